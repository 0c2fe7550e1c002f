# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the examples as a user does, and looks at what they leave.

    TestExamples.py SOURCE_FOLDER BUILD_FOLDER SCRATCH_FOLDER
"""

import pathlib
import shutil
import subprocess
import sys

import pemesh

SOURCE, BUILD, SCRATCH = (pathlib.Path(argument) for argument in sys.argv[1:4])


def run(example, *arguments):
    return subprocess.run([sys.executable, SOURCE / "Applications/Python/Examples" / example,
                           *arguments], cwd=SCRATCH, check=True, capture_output=True,
                          text=True).stdout


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    study = SOURCE / "Data/Studies/quickstart.json"
    text = run("quickstart.py", study, "python")
    assert "20 meshes" in text and "0 failures" in text, text
    subprocess.run([BUILD / "bin/pemesh", "run", study, "-o", SCRATCH / "command"], check=True,
                   capture_output=True)
    for file in ("results.csv", "correlation.csv", "findings.txt"):
        assert (SCRATCH / "python" / file).read_bytes() == (
            SCRATCH / "command" / file).read_bytes(), file

    text = run("own_solver.py", "own")
    table = pemesh.Table.read(SCRATCH / "own/with-own-solver.csv")
    condition = table["lumped_mass_condition"]
    assert table.rows == 8 and set(table["lumped_mass_Status"]) == {"ok"}
    assert (condition > 1).all() and condition[-1] > condition[0], condition
    assert "lumped_mass_condition" in text, text

    text = run("sweep.py", "sweep.csv")
    table = pemesh.Table.read(SCRATCH / "sweep.csv")
    assert table.rows == 10
    # The more it leans, the smaller the angle and the worse the condition.
    assert (table["MinAngle_min"][1:] < table["MinAngle_min"][:-1]).all()
    assert (table["vem_condition-number"][1:] > table["vem_condition-number"][:-1]).all()
    assert "strong negative" in text, text


main()
