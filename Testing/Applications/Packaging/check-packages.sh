#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the Debian packages of a build into a bare Debian 12, and uses them there:
#
#   cpack --preset release                                  # makes build/release/packages/*.deb
#   check-packages.sh build/release/packages [FOLDER]       # as root, with a network
#
# The root is made by debootstrap in FOLDER (default: a temporary one) and removed at the end. Not
# one of ctest's tests, since it needs root and the network.
set -eu

packages=$(realpath "$1")
root=${2:-$(mktemp -d)}
source=$(realpath "$(dirname "$0")/../../..")
mirror=${PEMESH_DEBIAN_MIRROR:-http://deb.debian.org/debian}
say() { printf '==> %s\n' "$*"; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }
clean_up() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap clean_up EXIT

say "Making a bare Debian 12."
debootstrap --variant=minbase bookworm "$root" "$mirror" >/dev/null
mount -t proc proc "$root/proc"

say "Installing the packages."
cp "$packages"/*.deb "$root/root"
inside apt-get update -qq
inside sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
  /root/pemesh_*.deb /root/python3-pemesh_*.deb' >/dev/null

say "Running the quickstart."
inside sh -c 'cd /root && pemesh --version &&
  pemesh run /usr/share/pemesh/Studies/quickstart.json --report >log 2>&1 &&
  test "$(wc -l <quickstart/results.csv)" -eq 21 && test -s quickstart/report.html &&
  test ! -e quickstart/failures.csv' || { cat "$root/root/log"; exit 1; }

say "The window, the manual and Python."
inside sh -c 'pemesh-studio --version && test -s /usr/share/man/man1/pemesh-run.1'
inside python3 -c 'import pemesh; r = pemesh.Results("/root/quickstart"); print(r)
print(pemesh.metrics(r.mesh(0), ["Area"])["Area"].sum())'

say "A program of others."
inside sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
  /root/libpemesh-dev_*.deb cmake g++ make' >/dev/null
cp -r "$source/Testing/Applications/Packaging/Consumer" "$root/root/Consumer"
inside sh -c 'cd /root && printf "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n" >half.off &&
  cmake -S Consumer -B build -DPEMESH_HEADERS=/usr/include/pemesh >log 2>&1 &&
  cmake --build build >>log 2>&1 && test "$(build/consumer half.off)" = 0.785398163397448' ||
  { cat "$root/root/log"; exit 1; }

say "Removing them."
inside sh -c 'apt-get purge -y -qq pemesh libpemesh-dev python3-pemesh >/dev/null &&
  ! find /usr -path "*pemesh*" | grep .'
say "All is well."
