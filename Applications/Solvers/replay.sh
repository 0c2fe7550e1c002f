#!/bin/sh
# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Hands over results that were computed elsewhere, on a cluster or years ago:
#
#   replay.sh RESULTS OUTPUT STEM
#
# For the mesh STEM, all files RESULTS/STEM-*.txt are those of the answer. Results of version 1 of
# the predecessor are understood: STEM-VEM-sol.txt, STEM-GROUND-TRUTH-sol.txt, and output.txt with a
# line "errS errInf errL2 hEmax condVect" for each STEM-VEM-sol.txt of the folder, in order of name.
set -eu
results=$1 output=$2 stem=$3
fail() { echo "replay.sh: $*" >&2; exit 1; }

[ -d "$results" ] || fail "the folder \"$results\" with the results is missing: set the option results."
for file in "$results/$stem"-*.txt; do
  [ -e "$file" ] || fail "\"$results\" has no file $stem-*.txt."
  name=${file##*/"$stem"}
  case $name in
    -VEM-sol.txt) name=-solution.txt ;;
    -GROUND-TRUTH-sol.txt) name=-ground-truth.txt ;;
  esac
  cp -- "$file" "$output/$stem$name"
done

if [ -e "$results/$stem-VEM-sol.txt" ] && [ -e "$results/output.txt" ]; then
  line=0
  for file in "$results"/*-VEM-sol.txt; do
    line=$((line + 1))
    [ "${file##*/}" != "$stem-VEM-sol.txt" ] || break
  done
  # A first line of names is skipped; empty lines do not count.
  numbers=$(grep '[0-9]' "$results/output.txt" | grep -v 'errS' | sed -n "${line}p")
  [ -n "$numbers" ] || fail "output.txt has no line $line, which is that of $stem."
  # shellcheck disable=SC2086 # five words
  set -- $numbers
  for name in errS errInf errL2 hEmax condVect; do
    [ $# -gt 0 ] || fail "line $line of output.txt has too few numbers."
    echo "$1" > "$output/$stem-$name.txt"
    shift
  done
fi
