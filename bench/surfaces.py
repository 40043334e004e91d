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

A run is ended after 300 s of the clock, and its row says so. Nothing else should run on the machine meanwhile. Needs
Python 3.9, and numpy and scipy for the checks.
"""
import argparse
import json
import os
import tempfile

import page
from jobs import Referee, call_checker, chosen, digest, load_json, machine_text, run, say, source_commit
from tables import checked, failed_row, table, thousands

HERE = os.path.dirname(os.path.abspath(__file__))
EXTENSIONS = (".obj", ".ply", ".stl", ".ml", ".ts")
LIMIT = 300  # seconds of the clock for a run
TEXT = """# Quads on surfaces

Made by `bench/surfaces.py` (the text at the end apart), which anyone can rerun; do not edit the tables. Surfaces that are
not part of this repository: scans and models of odedstein/meshes, CAD parts of trimesh, faults of the SCEC community fault
model, a structural model of OpenGeode. Everything but `--count` is the default. SJ is the scaled Jacobian of a quad along
its own normal, its smallest corner's; % < 0.2 are quads whose SJ is below that; irregular are interior vertices with other
than four edges. The referee shares no code with quarry: all quads, none inverted, the surface's own topology, no face
upside down, which is one whose normal points away from the normals of all parts of the surface about as near as the
nearest. Corners turned are those whose normal stands at more than 72 degrees to every normal of the surface within half
of their face's longest edge (bench/turned_corners.py, which shares no code with quarry either). The referee also measures the distance both ways, in shares of the diagonal of the box, and how much of the length of the
edges above 40 degrees (on scans these are noise) and of the rims lies within a quarter of an element of such edges and rims
of the mesh. Times are whole processes, file to file, on one thread; the peak of memory is all that the process held, its
program and the surface too, over the quads. A run is ended after {limit} s of the clock.

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


def why_failed(done):
    """Why a run has no mesh; "" if it has one."""
    if done.code == -1:
        return f"over {LIMIT} s"
    return done.why if done.code else ""


def differing(command, folder, out, counts):
    """The numbers of threads that write other bytes than those there, or none, with why."""
    bytes_of_one, found = digest(out), []
    for threads in counts:
        why = why_failed(run([*command, "--threads", threads], folder, LIMIT))
        if why or digest(out) != bytes_of_one:
            found.append(f"{threads}: {why or 'differ'}")
    return found


def measure(options, referee, path, count, folder):
    out, report, repaired = (os.path.join(folder, name) for name in ("out.vtu", "out.json", "repaired.obj"))
    command = [options.quarry, "mesh", path, "-o", out, "--count", count, "--report", report, "--repaired", repaired]
    done = run([*command, "--threads", 1], folder, LIMIT)
    if why_failed(done):
        return {"error": why_failed(done)}
    told = load_json(report)
    row = {"quads": told["counts"]["quads"], "quality": told["quality"], "seconds": done.cpu,
           "peak": told["peak_memory_bytes"]}
    if referee.there:
        found = referee.call("surface.py", out, "--ref", repaired, "--all-quad")
        row["failed"] = found.get("failed", ["no answer"])
        row["largest"], row["mean"] = found.get("hausdorff"), found.get("ref2mesh", {}).get("mean")
        row["kept"], row["rims"] = (found.get(lines, {}).get("pct_kept_within_quarter_h")
                                    for lines in ("features", "boundary"))
        row["upside_down"] = found.get("upside_down")
        row["turned"] = turned_corners(options, referee, out, repaired, folder)
    row["threads"] = ["1", *options.threads.split(",")]
    row["differing"] = differing(command, folder, out, row["threads"][1:])
    return row


def turned_corners(options, referee, out, repaired, folder):
    plain = os.path.join(folder, "out.obj")
    run([options.quarry, "convert", out, plain, "--quiet"], folder)
    return call_checker(referee.python, os.path.join(HERE, "turned_corners.py"), plain, repaired).get("turned")


def row_of(name, row):
    if "error" in row:
        return failed_row(row, [name], len(HEADER))
    quality = row["quality"]
    jacobian = quality["scaled_jacobian"]

    def number(key, form):
        return "" if row.get(key) is None else format(row[key], form)

    return [name, thousands(row["quads"]), f"{100 * quality['valence']['irregular_share']:.2f}",
            f"{jacobian['min']:.3f}", f"{jacobian['mean']:.4f}", f"{100 * jacobian['share_below_0.2']:.3f}",
            number("largest", ".1e"), number("mean", ".1e"), number("kept", ".1f"), number("rims", ".1f"),
            number("upside_down", "d"), number("turned", "d"), checked(row),
            f"**{'; '.join(row['differing'])}**" if row["differing"] else ", ".join(row["threads"]),
            f"{row['seconds']:.2f}", thousands(row["quads"] / row["seconds"]), f"{row['peak'] / 1e3 / row['quads']:.2f}"]


HEADER = ["surface", "quads", "irregular %", "SJ min", "SJ mean", "% < 0.2", "largest distance", "mean",
          "sharp edges kept %", "rims kept %", "upside down", "corners turned", "referee", "same bytes on threads", "s", "quads/s",
          "peak kB a quad"]


def text_of(kept, missed):
    tables = []
    for count in sorted(kept["rows"], key=int):
        rows = kept["rows"][count]
        tables.append(f"## About {thousands(int(count))} quads\n\n"
                      + table(HEADER, [row_of(name, rows[name]) for name in sorted(rows)]))
    return TEXT.format(limit=LIMIT, machine=kept["machine"], commit=kept["commit"], tables="\n\n".join(tables),
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
    options = parser.parse_args()
    options.surfaces = names_of(os.path.join(options.data, "surface"))
    options.only = chosen(parser, options.only, dict(options.surfaces), "surfaces")
    return options


def main():
    options = parse()
    referee = Referee(options.referee)
    surfaces = [(name, file) for name, file in options.surfaces if not options.only or name in options.only]
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
