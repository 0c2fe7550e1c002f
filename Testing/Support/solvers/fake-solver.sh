#!/bin/sh
# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A solver for tests: fake-solver.sh MODE MESH OUTPUT STEM [ARGUMENT...]
# Its solution is the first coordinate of each vertex of an OFF mesh, its ground truth the second
# one; the modes other than "ok" are the ways in which a solver can go wrong.
mode=$1 mesh=$2 output=$3 stem=$4
shift 4
base=$output/$stem

write_answer()
{
  {
    read -r _
    read -r vertices _
    : > "$base-solution.txt"
    : > "$base-ground-truth.txt"
    while [ "$vertices" -gt 0 ] && read -r x y _; do
      echo "$x" >> "$base-solution.txt"
      echo "$y" >> "$base-ground-truth.txt"
      vertices=$((vertices - 1))
    done
  } < "$mesh"
  echo 4.5 > "$base-condition-number.txt"
  echo 0.25 > "$base-solve-seconds.txt"
}

case $mode in
  ok) write_answer; echo "all is well" ;;
  no-truth) write_answer; rm "$base-ground-truth.txt" ;;
  elements)
    write_answer
    echo nan > "$base-condition-number.txt"
    printf '0.5\n1\nnan\n' > "$base-ErrorL2.txt"
    printf '0.5\n1\n' > "$base-Short.txt" ;;
  slow) sleep 0.3; write_answer ;;
  status) write_answer; echo "a warning" >&2; echo "the matrix is singular." >&2; echo >&2; exit 3 ;;
  silent-status) exit 4 ;;
  signal) write_answer; echo "about to fall" >&2; kill -SEGV $$ ;;
  hang) echo "thinking" >&2; echo $$ > "$output/pids"; exec sleep 60 ;;
  hang-with-child) sleep 60 & echo $! > "$output/pids"; echo $$ >> "$output/pids"; wait ;;
  deaf) trap '' TERM; echo $$ > "$output/pids"; while :; do sleep 0.1; done ;;
  leave-child) write_answer; sleep 60 & echo $! > "$output/pids" ;;
  few) write_answer; sed -i 1d "$base-solution.txt" ;;
  many) write_answer; echo 1 >> "$base-solution.txt" ;;
  nan) write_answer; sed -i 2s/.*/nan/ "$base-solution.txt" ;;
  infinite) write_answer; echo inf > "$base-condition-number.txt" ;;
  word) write_answer; sed -i 3s/.*/0,5/ "$base-ground-truth.txt" ;;
  rubbish) write_answer; printf '\000\001\377\376%%s\n\n' > "$base-solution.txt" ;;
  empty) write_answer; : > "$base-solution.txt" ;;
  folder) write_answer; rm "$base-solution.txt"; mkdir "$base-solution.txt" ;;
  no-files) ;;
  pipes)
    for name in stdout.log stderr.log command.txt list.txt solved.txt "$stem.off" "$stem.node" \
      "$stem.ele" "$stem-solution.txt" "$stem-ground-truth.txt" "$stem-ErrorL2.txt"; do
      rm -f "$output/$name"; mkfifo "$output/$name"
    done
    echo again >> "$output/attempts"; exit 1 ;;
  endless)
    for name in stdout.log solved.txt "$stem.off" "$stem.node" "$stem-ground-truth.txt"; do
      ln -sf /dev/zero "$output/$name"
    done
    exit 1 ;;
  link-folder) write_answer; mv "$output" "$output-moved"; ln -s "$PRECIOUS" "$output"; exit "$1" ;;
  no-performance) write_answer; rm "$base-condition-number.txt" ;;
  two-numbers) write_answer; echo "1 2" > "$base-condition-number.txt" ;;
  no-number) write_answer; : > "$base-condition-number.txt" ;;
  link) write_answer; mv "$base-solution.txt" "$output/elsewhere"; ln -s elsewhere "$base-solution.txt" ;;
  fifo) write_answer; rm "$base-solution.txt"; mkfifo "$base-solution.txt" ;;
  huge) write_answer; head -c 3145728 /dev/zero | tr '\000' '1' > "$base-solution.txt" ;;
  wrong-mesh) stem=other; base=$output/$stem; write_answer ;;
  late) (sleep 5; write_answer) & ;;
  no-folder) write_answer; rm -r "$output" ;;
  big-file) exec head -c 100000000 /dev/zero > "$output/matrix" ;;
  many-files) i=0; while [ $i -lt 60 ]; do head -c 2000000 /dev/zero > "$output/part$i"; sleep 0.05; i=$((i + 1)); done ;;
  flood) write_answer; i=0; while [ $i -lt 3000 ]; do echo "$i: 0123456789012345678901234567890"; i=$((i + 1)); done ;;
  arguments) write_answer; printf '%s\n' "$@" > "$output/arguments.txt" ;;
  environment) write_answer; env > "$output/environment.txt"; pwd > "$output/folder.txt" ;;
  *) echo "unknown mode $mode" >&2; exit 2 ;;
esac
