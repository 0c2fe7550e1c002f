#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the ParaView plugin and checks it in Debian's ParaView, in a bare Debian 12 of its own, since
# paraview cannot be installed beside python3-vtk9.
#
#   check-plugin.sh PICTURE.png [FOLDER]      # as root, with a network; some 3 GB
#
# The root is made by debootstrap in FOLDER (default: a temporary one, removed at the end; one that
# is given is kept and used again). Not one of ctest's tests, since it needs root and the network.
set -eu

picture=$(realpath "$1")
root=${2:-}
here=$(realpath "$(dirname "$0")")
# shellcheck source-path=SCRIPTDIR source=paraview-root.sh
. "$here/paraview-root.sh"
make_root

say "Installing what the plugin is built with."
# What ParaView's and VTK's own configuration looks for comes after what PEMesh needs.
install_in_root g++ cmake ninja-build ccache pkg-config paraview-dev \
  libcgal-dev libeigen3-dev libboost-dev libsuitesparse-dev libopenblas-dev libspectra-dev \
  libginac-dev libmetis-dev libmatio-dev zlib1g-dev libcairo2-dev libfontconfig-dev \
  nlohmann-json3-dev libcli11-dev \
  libqt5svg5-dev qttools5-dev libopenmpi-dev libutfcpp-dev libdouble-conversion-dev liblz4-dev \
  liblzma-dev libpugixml-dev libgl2ps-dev libglew-dev libtiff-dev libjsoncpp-dev libtheora-dev \
  libogg-dev libnetcdf-dev libproj-dev libxml2-dev libfmt-dev libprotobuf-dev protobuf-compiler \
  libcgns-dev libexpat1-dev libsqlite3-dev python3-dev

say "Building the plugin."
mkdir -p "$root/root/pemesh"
git -C "$here/../.." ls-files -z | (cd "$here/../.." && tar c --null -T -) |
  tar x -C "$root/root/pemesh" --keep-newer-files 2>/dev/null || true
# shellcheck disable=SC2086 # a list of words
inside sh -c "cd /root/pemesh && cmake --preset paraview ${PEMESH_CMAKE_ARGUMENTS:-} >/dev/null &&
  cmake --build --preset paraview --target PEMesh >build-log.txt 2>&1 ||
  { grep -E -A6 'error|FAILED' build-log.txt | head -n 60; exit 1; }"

say "Running it in pvbatch."
inside sh -c 'cd /root/pemesh && xvfb-run -a pvbatch --force-offscreen-rendering \
  Testing/ParaView/check_plugin.py build/paraview/lib*/paraview-5.11/plugins/PEMesh/PEMesh.so \
  Data/Studies/quickstart.json build/paraview/plugin.png'
cp "$root/root/pemesh/build/paraview/plugin.png" "$picture"
say "All is well; the picture is $picture."
