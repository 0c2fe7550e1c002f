#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What PEMesh costs, and what it would cost where it is not measured.

    scale.py refresh BUILD [--sizes 1e4,1e5] [--meshes 10,300]   measure, and write page and results
    scale.py measure BUILD -o FILE.json [...]     measure alone
    scale.py page FILE.json                       write the tables of SCALE.md
    scale.py compare OLD.json NEW.json [--worse 1.2]    ratios; exit code 1 if something is worse

It runs the programs of a build (release) as a user does, and takes time and peak memory of each from
the system. A stage costs  start + elements * cost : both come from the sizes measured, so that what
a program needs to start is in neither. Python's standard library is all that it needs.
"""

import argparse
import datetime
import json
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE / "SCALE.md"
RESULTS = HERE / "Results"


def run(arguments, folder):
    """Runs a program; answers with its seconds (wall, processor) and peak bytes, with children."""
    begin = time.monotonic()
    process = subprocess.Popen(
        [str(argument) for argument in arguments],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"scale.py: {' '.join(map(str, arguments))} failed:\n{errors.decode()}")
    return {
        "seconds": time.monotonic() - begin,
        "processor": usage.ru_utime + usage.ru_stime,
        "bytes": 1024 * usage.ru_maxrss,
    }


def study(elements, **more):
    """Triangles around a maze in the unit square, about so many."""
    # A triangle of Delaunay's refinement has about half of the area that bounds it.
    document = {
        "pemesh": 1,
        "name": "scale",
        "polygons": [{"family": "maze"}],
        "sweep": [{"parameter": "t", "values": [0.5]}],
        "mesh": {"max-area": {"rule": "constant", "value": 1.7 / elements}, "min-angle": 20},
        "output": {"formats": ["vtp"]},
    }
    document.update(more)
    return json.dumps(document)


# One entry a stage: name, what is measured, and the command; {n}.vtp and {n}.off are the mesh.
STAGES = [
    ("generate", "triangles around a polygon, written as VTP", ["pemesh", "generate", "{n}.json", "-o", "{n}", "-j", "1"]),
    ("convert", "VTP read, OFF written", ["pemesh", "convert", "{n}.vtp", "-o", "{n}.off"]),
    ("check", "OFF read, all checks", ["pemesh", "check", "{n}.off"]),
    ("metrics", "OFF read, all metrics, their summary", ["pemesh", "metrics", "{n}.off", "-o", "{n}.csv"]),
    ("solve", "bundled solver, order 1", ["pemesh-vem", "--mesh", "{n}.off", "--output", "solved", "--details", "basic"]),
]


def measure_stages(binaries, folder, sizes):
    stages = {name: [] for name, _, _ in STAGES}
    for size in sizes:
        stem = str(int(size))
        (folder / f"{stem}.json").write_text(study(size))
        elements = 0
        for name, _, words in STAGES:
            arguments = [word.replace("{n}", stem) for word in words]
            cost = run([binaries / arguments[0], *arguments[1:]], folder)
            if name == "generate":
                next((folder / stem).glob("*.vtp")).rename(folder / f"{stem}.vtp")
            elif name == "convert":
                with open(folder / f"{stem}.off", encoding="ascii") as file:
                    elements = int(file.read(100).split()[2])
            stages[name].append(cost)
        for costs in stages.values():
            costs[-1]["elements"] = elements
    return stages


def measure_streaming(binaries, folder, counts, elements):
    """Peak memory of few meshes and of many of one size."""
    rows = []
    for count in counts:
        sweep = [{"parameter": "t", "from": 0, "to": 0.9, "count": int(count)}]
        (folder / "many.json").write_text(study(elements, sweep=sweep))
        cost = run([binaries / "pemesh", "run", "many.json", "-o", f"many{count}", "-j", "2"], folder)
        rows.append({"meshes": int(count), "elements": elements, **cost})
        shutil.rmtree(folder / f"many{count}")
    return rows


def measure_throughput(binaries, folder, meshes, elements):
    """One core, two threads, two processes."""
    sweep = [{"parameter": "t", "from": 0, "to": 0.9, "count": int(meshes)}]
    (folder / "through.json").write_text(study(elements, sweep=sweep))
    ways = {"1 thread": ["-j", "1"], "2 threads": ["-j", "2"]}
    rows = {}
    for way, options in ways.items():
        command = [binaries / "pemesh", "run", "through.json", "-o", "through", *options]
        rows[way] = run(command, folder)
        shutil.rmtree(folder / "through")
    if shutil.which("mpiexec"):
        os.environ.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
        command = ["mpiexec", "-n", "2", "--oversubscribe", "--bind-to", "none",
                   "--mca", "btl", "self,vader", "--mca", "btl_vader_single_copy_mechanism", "none",
                   binaries / "pemesh", "run", "through.json", "-o", "through", "-j", "1"]
        rows["2 processes"] = run(command, folder)
        shutil.rmtree(folder / "through")
    return {"meshes": int(meshes), "elements": elements, "ways": rows}


def measure(build, sizes, counts):
    binaries = pathlib.Path(build).resolve() / "bin"
    processors = [line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo", encoding="utf-8")
                  if line.startswith("model name")]
    before = os.getloadavg()[0]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        result = {
            "date": datetime.date.today().isoformat(),
            "machine": f"{len(processors) or os.cpu_count()} x {processors[0] if processors else platform.machine()}",
            "stages": measure_stages(binaries, folder, sizes),
            "streaming": measure_streaming(binaries, folder, counts, 3000),
            "throughput": measure_throughput(binaries, folder, max(20, counts[-1] // 10), 10000),
        }
    result["load"] = [before, os.getloadavg()[0]]
    return result


def slope(costs, key):
    """Cost an element, and what is left at the start: a line through the smallest and the largest."""
    first, last = costs[0], costs[-1]
    if last["elements"] == first["elements"]:
        return last[key] / last["elements"], 0.0
    cost = (last[key] - first[key]) / (last["elements"] - first["elements"])
    cost = max(cost, 0.0)
    return cost, max(first[key] - cost * first["elements"], 0.0)


def number(value):
    return f"{value:.3g}"


def duration(seconds):
    for unit, length in (("days", 86400), ("hours", 3600), ("minutes", 60)):
        if seconds >= 2 * length:
            return f"{number(seconds / length)} {unit}"
    return f"{number(seconds)} s"


def size(count):
    for unit, length in (("TB", 1e12), ("GB", 1e9), ("MB", 1e6)):
        if count >= length:
            return f"{number(count / length)} {unit}"
    return f"{number(count / 1e3)} kB"


def tables(result):
    loads = " to ".join(number(load) for load in result["load"])
    busy = max(result["load"]) > 1
    text = [f"Measured {result['date']} on {result['machine']}, load {loads} while it ran."
            + (" The machine was not quiet: the seconds of the clock, and their ratios, say little." if busy else ""), "",
            "| stage | what | us an element | bytes an element | s to start |", "|---|---|---|---|---|"]
    for name, what, _ in STAGES:
        seconds, start = slope(result["stages"][name], "processor")
        memory, _ = slope(result["stages"][name], "bytes")
        text.append(f"| {name} | {what} | {number(1e6 * seconds)} | {number(memory)} | {number(start)} |")
    text += ["", "| meshes | elements each | peak memory | seconds |", "|---|---|---|---|"]
    for row in result["streaming"]:
        text.append(f"| {row['meshes']} | {row['elements']} | {size(row['bytes'])} | {number(row['seconds'])} |")
    through = result["throughput"]
    base = through["ways"]["1 thread"]["seconds"]
    text += ["", f"{through['meshes']} meshes of {through['elements']} elements:", "",
             "| way | seconds | times one thread | processor seconds |", "|---|---|---|---|"]
    for way, cost in through["ways"].items():
        text.append(f"| {way} | {number(cost['seconds'])} | {number(base / cost['seconds'])} | {number(cost['processor'])} |")
    return "\n".join(text + ["", "What follows from it:", ""] + extrapolated(result))


def extrapolated(result):
    """10^6 meshes of 10^4 elements on 64 cores; one mesh of 10^9."""
    many, one = 1e6 * 1e4, 1e9
    text = ["| stage | 10^6 meshes of 10^4 elements, processor | the same on 64 cores | a mesh of 10^9 elements | its memory |",
            "|---|---|---|---|---|"]
    total = 0.0
    for name, _, _ in STAGES:
        seconds, _ = slope(result["stages"][name], "processor")
        memory, _ = slope(result["stages"][name], "bytes")
        total += seconds * many
        text.append(f"| {name} | {duration(seconds * many)} | {duration(seconds * many / 64)} | "
                    f"{duration(seconds * one)} | {size(memory * one)} |")
    text.append(f"| all | {duration(total)} | {duration(total / 64)} | | |")
    return text


def write_page(result):
    begin, end = "<!-- measured -->\n", "<!-- end of measured -->"
    page = PAGE.read_text(encoding="utf-8")
    head, rest = page.split(begin)
    tail = rest.split(end)[1]
    PAGE.write_text(head + begin + "\n" + tables(result) + "\n\n" + end + tail, encoding="utf-8")


def numbers_of(value, name=""):
    """All costs of a result by their path, numbers that say what was measured left out."""
    if isinstance(value, dict):
        for key, entry in value.items():
            yield from numbers_of(entry, f"{name}/{key}" if name else key)
    elif isinstance(value, list):
        for index, entry in enumerate(value):
            yield from numbers_of(entry, f"{name}/{index}")
    elif name.rsplit("/", 1)[-1] in ("seconds", "processor", "bytes"):
        yield name, float(value)


def compare(old, new, worse):
    """Any two results of benchmarks in JSON; what only one of them has is left out."""
    before, after = dict(numbers_of(old)), dict(numbers_of(new))
    status = 0
    for name in sorted(before.keys() & after.keys()):
        ratio = after[name] / before[name] if before[name] > 0 else 1.0
        mark = ""
        if ratio > worse:
            mark, status = "  worse", 1
        elif ratio < 1 / worse:
            mark = "  better"
        print(f"{ratio:6.2f}  {name}{mark}")
    return status


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("refresh", "measure"):
        command = commands.add_parser(name)
        command.add_argument("build")
        command.add_argument("--sizes", default="1e4,1e5", help="elements of one mesh")
        command.add_argument("--meshes", default="10,300", help="meshes of a study")
        if name == "measure":
            command.add_argument("-o", "--output", required=True)
    commands.add_parser("page").add_argument("result")
    command = commands.add_parser("compare")
    command.add_argument("old")
    command.add_argument("new")
    command.add_argument("--worse", type=float, default=1.2)
    arguments = parser.parse_args()

    def load(path):
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))

    if arguments.command == "compare":
        return compare(load(arguments.old), load(arguments.new), arguments.worse)
    if arguments.command == "page":
        write_page(load(arguments.result))
        return 0
    result = measure(arguments.build, [float(word) for word in arguments.sizes.split(",")],
                     [int(float(word)) for word in arguments.meshes.split(",")])
    path = pathlib.Path(arguments.output) if arguments.command == "measure" else (
        RESULTS / f"scale-{result['date']}.json")
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    if arguments.command == "refresh":
        write_page(result)
    print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
