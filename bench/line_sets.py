#!/usr/bin/python3
"""Meshes every set of lines at 1/200 of its box, has the referee check it, and writes docs/results-lines.md. From the
root of the repository:

  bench/line_sets.py [--data DIR] [--referee DIR] [--quarry build/quarry] [--only NAME,...] [--out FILE]

--data      folder with planar/ and ugly/; each set has NAME.lines.geojson, and its original where there is one
--referee   folder with section.py, an independent checker; without it that column stays empty
--only      sets whose names contain one of these, the table to stdout

The original is read where its format is; where it is refused, the table says why, and NAME.lines.geojson is read in its
place. Coordinates in degrees are taken as they are (`--as-is`), so that they can be compared.
"""
import argparse
import collections
import glob
import os
import tempfile

from jobs import Referee, load_json, machine_text, run, say, source_commit
from maps import box_of

ORIGINALS = (".geojson", ".txt", ".pl", ".json", ".dxf")
DIVISION = 200

PAGE = """# Every set of lines

Made by `bench/line_sets.py`, which anyone can rerun; do not edit. The line sets of a collection that is not part of this
repository, clean and dirty ones: each at a {division}th of the longer side of its box, everything else the default, on
one thread. Crossings became nodes; the largest move is of a point of a line, as a share of H; irregular are interior
vertices with other than four edges. Seconds are the processor's. Referee: valid, conforming, complete, every input line
within snap + min-edge + tolerance of its own edges, all quads, longest edge of a face at most 12 times its shortest.

Machine: {machine}. Sources as of {commit}.

{table}

{passed} of {all} pass. {refused}
"""


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", default="../shared/data")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--only", default="")
    parser.add_argument("--out", default="docs/results-lines.md")
    return parser.parse_args()


def line_sets(data):
    """(name, its lines as GeoJSON, its original or None), by name."""
    found = []
    for lines in sorted(glob.glob(os.path.join(data, "planar", "*.lines.geojson")) +
                        glob.glob(os.path.join(data, "ugly", "*.lines.geojson"))):
        stem = lines[:-len(".lines.geojson")]
        original = next((stem + ending for ending in ORIGINALS if os.path.exists(stem + ending)), None)
        found.append((os.path.basename(stem), lines, original))
    return found


class Bench:
    def __init__(self, arguments, folder):
        self.quarry, self.folder = arguments.quarry, folder
        self.referee = Referee(arguments.referee)

    def mesh(self, source, size):
        """(run, mesh, report); a second try takes degrees as they are."""
        out, report = os.path.join(self.folder, "out.vtu"), os.path.join(self.folder, "report.json")
        command = [self.quarry, "mesh", source, "--size", f"{size:.12g}", "-o", out, "--report", report, "--threads",
                   "1", "--quiet"]
        done = run(command, self.folder)
        if done.code == 3 and "--as-is" in done.errors:
            done = run([*command, "--as-is"], self.folder)
        return done, out, report

    def measure(self, name, lines, original):
        x0, y0, x1, y1 = box_of(lines)
        size = max(x1 - x0, y1 - y0) / DIVISION
        row = {"name": name, "source": os.path.basename(original or lines)}
        done, mesh, report = self.mesh(original or lines, size)
        if done.code == 3 and original:
            row.update(refused=done.why, source=os.path.basename(lines))
            done, mesh, report = self.mesh(lines, size)
        say(f"{name}: {done.cpu:.1f} s" + ("" if done.code == 0 else f", {done.why}"))
        if done.code != 0:
            return {**row, "error": done.why}
        job = load_json(report)
        verdict = self.referee.section(mesh, lines, report)["failed"] if self.referee.there else None
        return {**row, "job": job, "size": size, "cpu": done.cpu, "failed": verdict}


def dropped(job):
    reasons = collections.Counter(line["why"].split(":")[0] for line in job["input"]["lines"] if line["fate"] == "dropped")
    return ", ".join(f"{count} {reason}" for reason, count in sorted(reasons.items())) or "0"


def table_row(row):
    if "error" in row:
        return f"| {row['name']} | {row['source']} | {row['error']} |" + " |" * 11
    job, quality = row["job"], row["job"]["quality"]
    counts, jacobian = job["counts"], quality["scaled_jacobian"]
    referee = "" if row["failed"] is None else "ok" if not row["failed"] else "**" + "; ".join(row["failed"]) + "**"
    return (f"| {row['name']} | {row['source']} | {counts['input_lines']:,} | {counts['cleaned_pieces']:,} | "
            f"{counts['crossings']:,} | {dropped(job)} | {counts['largest_move'] / row['size']:.3f} | "
            f"{counts['quads']:,} | {jacobian['min']:.3f} | {jacobian['mean']:.4f} | "
            f"{100 * quality['valence']['irregular_share']:.2f} | {row['cpu']:.1f} | "
            f"{job['peak_memory_bytes'] / 1e6:.0f} | {referee} |")


HEADING = """| set | read from | lines | pieces | crossings | dropped | largest move / H | quads | SJ min | SJ mean | % irregular | s | peak MB | referee `failed` |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"""


def main():
    arguments = parse()
    only = [name for name in arguments.only.split(",") if name]
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder)
        rows = [bench.measure(*each) for each in line_sets(arguments.data)
                if not only or any(name in each[0] for name in only)]
    table = "\n".join([HEADING, *map(table_row, rows)])
    if only:
        print(table)
        return
    refused = [f"`{os.path.basename(row['source'])}` stands in for its original: {row['refused']}" for row in rows
               if "refused" in row]
    page = PAGE.format(division=DIVISION, machine=machine_text(), commit=source_commit(), table=table, all=len(rows),
                       passed=sum(not row.get("failed", ["error"]) for row in rows),
                       refused="\n\n".join(["", *refused]))
    with open(arguments.out, "w") as file:
        file.write(page)
    say(f"wrote {arguments.out}")


if __name__ == "__main__":
    main()
