#!/usr/bin/env python3
"""One network on more and more threads: the seconds of each stage, memory, and whether the bytes stay the same. Prints
a table in Markdown, as they stand in docs/results-scaling.md; ends with 1 if any mesh has other bytes, or a run fails.

usage: scaling.py [--quarry build/quarry] [--segments 100000] [--threads 1,2,4,8,16] [--limit 3600] [-- OPTIONS OF MESH]

The network is that of bench/networks.py with so many segments; single runs, file to file.
"""
import argparse
import os
import sys
import tempfile

from jobs import digest, load_json, machine_text, run, say, source_commit
from networks import SHAPES

CLEAN_UP = "of_cleanup"
STEPS = ("operators", "patches", "chords", "smoothing")  # of clean-up


def measure(arguments, folder):
    """A dictionary for each number of threads."""
    count, density = next(shape for shape in SHAPES.values() if shape[0] == arguments.segments)
    lines, mesh, report = (os.path.join(folder, name) for name in ("lines.geojson", "mesh.vtu", "report.json"))
    run([arguments.quarry, "generate", "fractures", "--count", count, "-o", lines, "-q"], folder)
    for threads in map(int, arguments.threads.split(",")):
        command = [arguments.quarry, "mesh", lines, "--size", f"{density / count**0.5:.12g}", "-o", mesh, "--report", report,
                   "--threads", threads, "--quiet", *arguments.options]
        done = run(command, folder, arguments.limit)
        say(f"{count} segments on {threads} threads: {done.wall:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        row = {"threads": threads, "wall": done.wall, "cpu": done.cpu, "code": done.code}
        if done.code == 0:
            job = load_json(report)
            row.update(times=job["times"], peak=job["peak_memory_bytes"], digest=digest(mesh),
                       elements=job["counts"]["quads"] + job["counts"]["triangles"])
        yield row


def seconds(row, stage):
    times = row["times"]
    return times.get(CLEAN_UP, {}).get(stage) if stage in STEPS else times.get(stage)


def table(arguments, rows):
    finished = [row for row in rows if row["code"] == 0]
    if not finished:
        return "No run came to its end.\n"
    first = finished[0]
    stages = []
    for stage in first["times"]:
        if stage not in (CLEAN_UP, "total"):
            stages.append(stage)
        if stage == "clean-up" and CLEAN_UP in first["times"]:
            stages += STEPS
    head = [f"{row['threads']} thread{'s' if row['threads'] > 1 else ''} s" for row in finished]
    lines = [f"## {arguments.segments:,} fractures, {first['elements']:,} elements", "",
             f"Options: `{' '.join(arguments.options) or 'none'}`. {machine_text()}; sources as of {source_commit()}.", "",
             "| stage | " + " | ".join(head) + " | first by last |", "|---" * (len(head) + 2) + "|"]
    for stage in [*stages, "total"]:
        values = [seconds(row, stage) or 0.0 for row in finished]
        name = f"- {stage}" if stage in STEPS else stage
        ratio = f"{values[0] / values[-1]:.1f}" if values[-1] > 0 else ""
        lines.append(f"| {name} | " + " | ".join(f"{value:.2f}" for value in values) + f" | {ratio} |")
    lines.append("| processor time | " + " | ".join(f"{row['cpu']:.2f}" for row in finished) + " | |")
    lines.append("| us an element | " + " | ".join(f"{1e6 * row['wall'] / row['elements']:.2f}" for row in finished) + " | |")
    lines.append("| peak memory, MB | " + " | ".join(f"{row['peak'] / 1e6:.0f}" for row in finished) + " | |")
    same = "the same bytes" if len({row["digest"] for row in finished}) == 1 else "OTHER BYTES"
    lines += ["", f"On {', '.join(str(row['threads']) for row in finished)} threads: {same}.", ""]
    return "\n".join(lines)


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--segments", type=int, default=100000, choices=[shape[0] for shape in SHAPES.values()])
    parser.add_argument("--threads", default="1,2,4,8,16")
    parser.add_argument("--limit", type=float, default=3600)
    parser.add_argument("options", nargs="*", help="of quarry mesh, after --")
    return parser.parse_args()


def main():
    arguments = parse()
    with tempfile.TemporaryDirectory() as folder:
        rows = list(measure(arguments, folder))
    print(table(arguments, rows))
    digests = {row.get("digest") for row in rows}
    sys.exit(0 if len(digests) == 1 and None not in digests else 1)


if __name__ == "__main__":
    main()
