#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Opens results of a study in Debian's ParaView, which cannot be installed beside python3-vtk9: in a
# bare Debian 12 of its own.
#
#   check-paraview.sh RESULTS PICTURE.png [FOLDER]      # as root, with a network
#
# The root is made by debootstrap in FOLDER (default: a temporary one, removed at the end; one that
# is given is kept and used again). Not one of ctest's tests, since it needs root and the network.
set -eu

results=$(realpath "$1")
picture=$(realpath "$2")
root=${3:-}
here=$(realpath "$(dirname "$0")")
# shellcheck source-path=SCRIPTDIR source=paraview-root.sh
. "$here/paraview-root.sh"
make_root

say "Opening $results."
rm -rf "$root/root/results"
cp -r "$results" "$root/root/results"
cp "$here/check_series.py" "$root/root"
inside sh -c 'cd /root && xvfb-run -a pvbatch --force-offscreen-rendering check_series.py results picture.png'
cp "$root/root/picture.png" "$picture"
say "All is well; the picture is $picture."
