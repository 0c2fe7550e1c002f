#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# From a bare Debian 12 to a running PEMesh. As root, or with sudo:
#
#   ./bootstrap.sh demo    install what is missing, build, run the demonstration study
#   ./bootstrap.sh test    install what is missing, build, run all tests
#   ./bootstrap.sh build   install what is missing, build
#   ./bootstrap.sh install-packages   only install what is missing
#
# A second call finds everything in place and takes seconds. Further arguments go to the program
# that is run: the study runner for demo, ctest for test. The variable PEMESH_CMAKE_ARGUMENTS
# holds further arguments for cmake.
set -eu
cd "$(dirname "$0")"

build_packages="g++ cmake ninja-build ccache pkg-config ca-certificates help2man
  libvtk9-dev libcgal-dev libeigen3-dev libboost-dev libsuitesparse-dev libopenblas-dev
  libspectra-dev libginac-dev libmetis-dev libmatio-dev zlib1g-dev
  libcairo2-dev libfontconfig-dev qt6-base-dev qt6-tools-dev qt6-l10n-tools
  nlohmann-json3-dev libcli11-dev
  libgtest-dev libgmock-dev libopenmpi-dev"
run_packages="fonts-dejavu-core python3 python3-dev python3-vtk9 python3-numpy"
# octave, which one more test needs, is large: it runs where octave-cli is installed.
test_packages="librsvg2-bin poppler-utils xvfb openmpi-bin"

say() { printf '==> %s\n' "$*"; }
fail() { printf 'bootstrap.sh: %s\n' "$*" >&2; exit 1; }

usage() {
  sed -n '3,/^set/{/^set/d;s/^# \{0,1\}//;p;}' "$0"
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null 2>&1; then
    sudo "$@"
  else
    fail "packages must be installed, which needs root: run it as root or install sudo."
  fi
}

install_packages() {
  command -v dpkg-query >/dev/null 2>&1 ||
    fail "this is not a Debian system; install the packages named in this file by other means."
  missing=""
  for package in $build_packages $run_packages $test_packages; do
    state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing="$missing $package"
  done
  if [ -z "$missing" ]; then
    say "All packages are installed."
    return
  fi
  say "Installing the missing Debian packages:$missing"
  as_root apt-get update -qq
  # shellcheck disable=SC2086 # a list of words
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    $missing >/dev/null || fail "apt-get could not install them: see its message above."
}

# With arguments, builds only these targets.
build() {
  cores=$(nproc)
  say "Configuring."
  # shellcheck disable=SC2086 # a list of words
  cmake --preset release ${PEMESH_CMAKE_ARGUMENTS:-} >build-log.txt 2>&1 ||
    { tail -n 40 build-log.txt; fail "cmake failed: the whole log is build-log.txt."; }
  say "Building with $cores cores (the first time takes some minutes)."
  cmake --build --preset release --parallel "$cores" ${*:+--target "$@"} >>build-log.txt 2>&1 ||
    { grep -E -A6 'error|FAILED' build-log.txt | head -n 60
      fail "the build failed: the whole log is build-log.txt."; }
}

command=${1:-help}
[ $# -eq 0 ] || shift
case "$command" in
  demo)
    install_packages
    build pemesh pemesh-vem
    say "Running the study Data/Studies/quickstart.json."
    build/release/bin/pemesh run Data/Studies/quickstart.json -o quickstart "$@"
    say "The study is in $(pwd)/quickstart, its plots in $(pwd)/quickstart/plots."
    ;;
  test)
    install_packages
    build
    say "Running all tests."
    ctest --preset release --parallel "$(nproc)" "$@"
    ;;
  build)
    install_packages
    build
    ;;
  install-packages)
    install_packages
    ;;
  help | -h | --help)
    usage
    ;;
  *)
    usage
    fail "\"$command\" is not one of demo, test, build, install-packages."
    ;;
esac
