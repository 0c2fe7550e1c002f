#!/bin/sh
# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A solver for tests that takes a list of meshes: fake-list.sh LIST
# What goes wrong with a mesh is in its name. Every call leaves its number of meshes in calls.txt.
grep -c '' "$1" >> calls.txt
while IFS= read -r mesh; do
  folder=${mesh%/*} stem=${mesh##*/}
  stem=${stem%.off}
  echo "$stem"
  case $stem in
    *crash*) kill -SEGV $$ ;;
    *hang*) sleep 60 ;;
    *omit*) continue ;;
  esac
  "${0%/*}/fake-solver.sh" ok "$mesh" "$folder" "$stem"
done < "$1"
