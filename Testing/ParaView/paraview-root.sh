# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# A bare Debian 12 with ParaView in the folder $root, for the scripts beside this one, which set it:
# empty means a temporary folder, which is removed at the end.
mirror=${PEMESH_DEBIAN_MIRROR:-http://deb.debian.org/debian}
say() { printf '==> %s\n' "$*"; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }

install_in_root() {
  inside env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" \
    >/dev/null
}

clean_up() {
  umount "$root/proc" 2>/dev/null || true
  [ "$keep" = yes ] || rm -rf --one-file-system "$root"
}

make_root() {
  keep=yes
  [ -n "$root" ] || { root=$(mktemp -d); keep=no; }
  trap clean_up EXIT
  if [ ! -x "$root/usr/bin/pvbatch" ]; then
    say "Making a bare Debian 12 with ParaView."
    debootstrap --variant=minbase bookworm "$root" "$mirror" >/dev/null
    inside apt-get update -qq
    install_in_root paraview python3-paraview xvfb xauth libgl1-mesa-dri
  fi
  mount -t proc proc "$root/proc"
}
