#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   run-fuzzers.sh RUNS [FORMAT...]
#
# Runs the fuzzer of mesh formats RUNS times for each format (default: all that there are).
set -eu
cd "$(dirname "$0")/../.."
runs=${1:?"how many runs?"}
shift
fuzzer=build/fuzz/bin/FuzzMeshFormats
formats=${*:-off obj node stl vtp vtu vtk ply gmsh mat}

for format in $formats; do
  corpus=build/fuzz/corpus/$format
  mkdir -p "$corpus"
  for seed in Testing/Fuzzing/Seeds/"$format"/* Testing/Data/Meshes/*/*."$format"; do
    [ ! -f "$seed" ] || cp "$seed" "$corpus"
  done
  echo "==> $format"
  limits="-malloc_limit_mb=64"
  sanitizer=""
  case $format in
    vtp | vtu) limits="-malloc_limit_mb=100000"; sanitizer="detect_leaks=0:allocator_may_return_null=1" ;; # VTK's readers
  esac
  # zlib makes at most 1032 bytes of one: the largest input could hold 4 MB.
  # shellcheck disable=SC2086 # a list of words
  ASAN_OPTIONS=$sanitizer "$fuzzer" --format="$format" --seeds="$corpus" "$corpus" -runs="$runs" -max_len=4096 \
    $limits -timeout=10 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix=build/fuzz/ 2>&1 | grep -E 'ERROR|SUMMARY|stat::number_of_executed_units|#[0-9] ' || true
  [ -z "$(find build/fuzz -maxdepth 1 -name 'crash-*' -newer "$corpus")" ] || exit 1
done
