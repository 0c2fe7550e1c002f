# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The quickstart: a whole study in one call.

    quickstart.py STUDY.json FOLDER
"""

import sys

import pemesh

results = pemesh.run(sys.argv[1], sys.argv[2], progress=lambda done: print(f"{done:4.0%}", end="\r"))
print(results)
for sentence in results.failures:
    print(sentence)
print(results.findings)
