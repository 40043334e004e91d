#!/usr/bin/python3
"""Meshes triangulated surfaces with quads, checks them and writes docs/results-surfaces.md. From the root of the
repository:

  bench/surfaces.py [--data DIR] [--referee DIR] [--quarry build/quarry] [--counts 10000,50000] [--only NAME,...]
                    [--threads 2,4,7] [--quick] [--add] [--keep FILE.json] [--out docs/results-surfaces.md]

--data      folder with surface/* (the surfaces are not part of this repository)
--referee   folder with surface.py, an independent checker; without it its columns stay empty
--counts    wanted numbers of quads
--threads   numbers of threads whose bytes are compared with those of one
--quick     2,000 quads of three surfaces, the page to stdout: to see that everything works
--keep      the measurements as JSON, written after each surface; default out/surfaces.json
--add       goes on with what that file has

Nothing else should run on the machine meanwhile. Needs Python 3.9, and numpy and scipy for the checks.
"""
import argparse
import json
import os
import tempfile

import page
from jobs import Referee, digest, load_json, machine_text, run, say, source_commit
from tables import checked, table, thousands

EXTENSIONS = (".obj", ".ply", ".stl", ".ml", ".ts")
TEXT = """# Quads on surfaces

Made by `bench/surfaces.py` (the text at the end apart), which anyone can rerun; do not edit the tables. Surfaces that are
not part of this repository: scans and models of odedstein/meshes, CAD parts of trimesh, faults of the SCEC community fault
model, a structural model of OpenGeode. Everything but `--count` is the default. SJ is the scaled Jacobian of a quad along
its own normal, its smallest corner's; irregular are interior vertices with other than four edges. The referee shares no
code with quarry: all quads, none inverted, none upside down on the surface, the surface's own topology; it also measures
the distance both ways, in shares of the diagonal of the box, and how much of the edges above 40 degrees lies within a
quarter of an element (on scans these are noise). Times are whole processes, file to file, on one thread.

Machine: {machine}. Source: {commit}.

{tables}

{missed_heading}
{missed}"""


def names_of(folder):
    """Each surface once, by its plainest format."""
    files = {}
    for extension in reversed(EXTENSIONS):
        for file in sorted(os.listdir(folder)):
            if file.endswith(extension):
                files[file[:-len(extension)]] = file
    return sorted(files.items())


def measure(options, referee, path, count, folder):
    out, report, repaired = (os.path.join(folder, name) for name in ("out.vtu", "out.json", "repaired.obj"))
    command = [options.quarry, "mesh", path, "-o", out, "--count", count, "--report", report, "--repaired", repaired]
    done = run([*command, "--threads", 1], folder)
    if done.code != 0:
        return {"error": done.why}
    told = load_json(report)
    row = {"quads": told["counts"]["quads"], "quality": told["quality"], "seconds": done.cpu, "peak": done.peak}
    bytes_of_one = digest(out)
    if referee.there:
        found = referee.call("surface.py", out, "--ref", repaired, "--all-quad")
        row["failed"] = found.get("failed", ["no answer"])
        row["largest"], row["mean"] = found.get("hausdorff"), found.get("ref2mesh", {}).get("mean")
        row["kept"] = found.get("features", {}).get("pct_kept_within_quarter_h")
    row["same"] = True
    row["threads"] = [1, *map(int, options.threads.split(","))]
    for threads in row["threads"][1:]:
        again = run([*command, "--threads", threads], folder)
        row["same"] = row["same"] and again.code == 0 and digest(out) == bytes_of_one
    return row


def row_of(name, row):
    if "error" in row:
        return [name, row["error"], *[""] * 10]
    quality = row["quality"]
    jacobian = quality["scaled_jacobian"]
    number = lambda value, form: "" if value is None else format(value, form)
    return [name, thousands(row["quads"]), f"{100 * quality['valence']['irregular_share']:.2f}",
            f"{jacobian['min']:.3f}", f"{jacobian['mean']:.4f}", number(row.get("largest"), ".1e"),
            number(row.get("mean"), ".1e"), number(row.get("kept"), ".1f"), checked(row),
            ", ".join(map(str, row.get("threads", [1, 2, 4, 7]))) if row["same"] else "**differ**", f"{row['seconds']:.2f}", f"{row['quads'] / row['seconds']:,.0f}"]


HEADER = ["surface", "quads", "irregular %", "SJ min", "SJ mean", "largest distance", "mean", "sharp edges kept %", "referee",
          "same bytes on threads", "s", "quads/s"]


def text_of(kept, missed):
    tables = []
    for count in sorted(kept["rows"], key=int):
        rows = kept["rows"][count]
        tables.append(f"## About {thousands(int(count))} quads\n\n"
                      + table(HEADER, [row_of(name, rows[name]) for name in sorted(rows)]))
    return TEXT.format(machine=kept["machine"], commit=kept["commit"], tables="\n\n".join(tables),
                       missed_heading=page.MISSED_HEADING, missed=missed)


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", default="../shared/data")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--counts", default="10000,50000")
    parser.add_argument("--only", default="")
    parser.add_argument("--threads", default="2,4,7")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--add", action="store_true")
    parser.add_argument("--keep", default="out/surfaces.json")
    parser.add_argument("--out", default="docs/results-surfaces.md")
    return parser.parse_args()


def main():
    options = parse()
    referee = Referee(options.referee)
    surfaces = names_of(os.path.join(options.data, "surface"))
    only = [name for name in options.only.split(",") if name]
    if options.quick:
        options.counts, surfaces = "2000", surfaces[:3]
    kept = {"machine": machine_text(), "commit": source_commit(), "rows": {}}
    if options.add:
        kept["rows"] = load_json(options.keep)["rows"]
    os.makedirs(os.path.dirname(options.keep) or ".", exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for count in options.counts.split(","):
            rows = kept["rows"].setdefault(count, {})
            for name, file in surfaces:
                if only and name not in only:
                    continue
                say(f"{name}, {count}")
                rows[name] = measure(options, referee, os.path.join(options.data, "surface", file), count, folder)
                with open(options.keep, "w") as file:
                    json.dump(kept, file, indent=1)
    if options.quick:
        print(text_of(kept, ""))
        return
    page.write(options.out, kept, text_of)


if __name__ == "__main__":
    main()
