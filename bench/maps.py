#!/usr/bin/python3
"""Meshes real maps with the command, measures, checks and writes docs/results.md. From the root of the repository:

  bench/maps.py [--data DIR] [--referee DIR] [--quarry build/quarry] [--tables ABCDEFG] [--repeat 3] [--quick]

--data      folder with planar/NAME.lines.geojson (the maps are not part of this repository)
--referee   folder with section.py and planar_quality.py, independent checkers; without it those columns stay empty
--tables    measures only these, and takes the others from the measurements that --keep holds; "": only writes the page
--quick     small sizes, one run each, tables to stdout: to see that everything works
--keep      the measurements as JSON; default out/maps.json (out/maps_quick.json)

  A maps x sizes: quality, time, bytes on 1, 2, 4, 7 threads       E larger meshes
  B the published procedure beside the default                       F a start of four triangles (Fig. 13)
  C triangles from a Delaunay start (Fig. 9)                         G histogram of smallest angles (Fig. 12)
  D speed against gmsh on the same cleaned lines

Nothing else should run on the machine meanwhile. Needs Python 3.9 and no more; the checkers need numpy and scipy.
"""
import argparse
import concurrent.futures
import json
import os
import shutil
import tempfile

import page
from gmsh_peer import prepare_gmsh
from jobs import Referee, Run, digest, load_json, machine_text, median_run, run, say

MAPS = ("kb11_traces", "hastholmen_traces", "souter_all", "lineaments_200k", "section_model_a1_x2500")
OUTLINES = {"kb11_traces": "kb11_area"}
THREADS = (1, 2, 4, 7)


def box_of(path):
    """Of the lines of a GeoJSON: (x min, y min, x max, y max)."""
    points = []

    def collect(coordinates):
        if coordinates and isinstance(coordinates[0], (int, float)):
            points.append(coordinates)
        else:
            for item in coordinates:
                collect(item)

    for feature in load_json(path)["features"]:
        collect(feature["geometry"]["coordinates"])
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return min(xs), min(ys), max(xs), max(ys)


class Bench:
    def __init__(self, arguments, folder):
        self.quarry, self.folder = arguments.quarry, folder
        self.planar = os.path.join(arguments.data, "planar")
        self.referee = Referee(arguments.referee)
        self.repeat = 1 if arguments.quick else arguments.repeat
        self.quick = arguments.quick
        self.sizes = (150,) if arguments.quick else (150, 300, 600)
        self.fine = 150 if arguments.quick else 600
        self.boxes = {name: box_of(self.lines(name)) for name in MAPS}

    def lines(self, name):
        return os.path.join(self.planar, f"{name}.lines.geojson")

    def size(self, name, division):
        x0, y0, x1, y1 = self.boxes[name]
        return max(x1 - x0, y1 - y0) / division

    def path(self, *parts):
        return os.path.join(self.folder, "_".join(map(str, parts)))

    def boundary(self, name):
        return ["--boundary", self.lines(OUTLINES[name])] if name in OUTLINES else []

    def mesh(self, name, division, tag, threads=1, extra=(), limit=1200, boundary=None):
        """One job -> (run, path of the mesh, path of the report)."""
        out, report = self.path(name, division, tag + ".vtu"), self.path(name, division, tag + ".json")
        command = [self.quarry, "mesh", self.lines(name), *(self.boundary(name) if boundary is None else boundary),
                   "--size", f"{self.size(name, division):.12g}", "-o", out, "--report", report,
                   "--cleanup", "none", "--threads", str(threads), "--quiet", *extra]
        done = run(command, self.folder, limit)
        say(f"{name} 1/{division} {tag}: {done.wall:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        return done, out, report

    def judged(self, name, mesh, report, elements="quad"):
        """What the independent checkers say of a mesh; nothing where they are not at hand."""
        if not self.referee.there:
            return {}
        verdict = self.referee.section(mesh, self.lines(name), report, all_quad=elements == "quad")
        quality = self.referee.quality(mesh).get(elements, {})
        return {"failed": verdict.get("failed", ["no answer"]), "referee_quality": quality}


def facts(done, report):
    """The figures of one job as a plain dictionary."""
    if done.code != 0:
        return {"error": done.why, "wall": done.wall}
    job = load_json(report)
    return {"wall": done.wall, "cpu": done.cpu, "peak": job["peak_memory_bytes"], "counts": job["counts"],
            "quality": job["quality"], "options": job["options"], "times": job["times"]}


def timed(bench, name, division, tag, threads, extra=()):
    """A job run several times: medians of its times."""
    runs = []
    for _ in range(bench.repeat):
        done, mesh, report = bench.mesh(name, division, tag, threads, extra)
        runs.append(done)
        if done.code != 0:
            break
    return median_run(runs), mesh, report


def table_a(bench):
    """All maps and sizes; then, while nothing is timed, what the checkers say."""
    rows, to_judge = [], []
    for name in MAPS:
        for division in bench.sizes:
            done, mesh, report = timed(bench, name, division, "t1", 1)
            row = {"map": name, "division": division, **facts(done, report)}
            rows.append(row)
            if done.code != 0:
                continue
            digests = [digest(mesh)]
            for threads in THREADS[1:]:
                other, copy, _ = bench.mesh(name, division, f"t{threads}", threads)
                digests.append(digest(copy) if other.code == 0 else other.why)
                if other.code == 0:
                    os.remove(copy)
            row["same_bytes"] = len(set(digests)) == 1
            to_judge.append((row, name, mesh, report))
    judge_all(bench, to_judge)
    return rows


def judge_all(bench, to_judge):
    def judge(item):
        row, name, mesh, report = item
        row.update(bench.judged(name, mesh, report))
        os.remove(mesh)
        say(f"checked {name} 1/{row['division']}: {row.get('failed', 'no checkers')}")

    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        list(pool.map(judge, to_judge))


def table_b(bench):
    rows = []
    for name in MAPS:
        for division in bench.sizes:
            for preset in ("default", "paper"):
                done, _, report = bench.mesh(name, division, preset, 1, ("--preset", preset), 300)
                rows.append({"map": name, "division": division, "preset": preset, **facts(done, report)})
    return rows


def table_c(bench):
    rows = []
    for start in ("delaunay", "4-8"):
        done, mesh, report = bench.mesh("souter_all", bench.fine, "tri_" + start, 1,
                                        ("--elements", "tri", "--start", start))
        row = {"start": start, **facts(done, report)}
        if done.code == 0:
            row.update(bench.judged("souter_all", mesh, report, "tri"))
        rows.append(row)
    return rows


def table_g(bench):
    """Histograms of the maps, souter_all at half the size: its nodes lie closer than the others'."""
    rows = []
    for name in MAPS:
        division = bench.fine * (2 if name == "souter_all" and not bench.quick else 1)
        done, _, report = bench.mesh(name, division, "angles")
        rows.append({"map": name, "division": division, **facts(done, report)})
    return rows


def write_four_triangles(path, box):
    """A start must reach beyond the lines on all sides: a box larger by a tenth, cut along its diagonals."""
    margin = 0.05 * max(box[2] - box[0], box[3] - box[1])
    x0, y0, x1, y1 = box[0] - margin, box[1] - margin, box[2] + margin, box[3] + margin
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), ((x0 + x1) / 2, (y0 + y1) / 2)]
    with open(path, "w") as file:
        file.writelines(f"v {x!r} {y!r} 0\n" for x, y in corners)
        file.writelines(f"f {i + 1} {(i + 1) % 4 + 1} 5\n" for i in range(4))


def table_f(bench):
    name = "section_model_a1_x2500"
    start = bench.path("four_triangles.obj")
    write_four_triangles(start, bench.boxes[name])
    rows = []
    for division in bench.sizes:
        for label, extra in (("four triangles", ("--start", start)), ("4-8", ())):
            done, mesh, report = bench.mesh(name, division, label.replace(" ", "_"), 1, extra,
                                            boundary=["--boundary", "box"])
            row = {"start": label, "division": division, **facts(done, report)}
            if done.code == 0:
                row.update(bench.judged(name, mesh, report))
            rows.append(row)
    return rows


def table_d(bench):
    """Whole processes in turn, so that what else the machine does falls on all of them alike."""
    name, division = "kb11_traces", bench.fine
    first, _, report = bench.mesh(name, division, "speed")
    if first.code != 0:
        return {"error": first.why}
    quads = load_json(report)["counts"]["quads"]
    peers = prepare_gmsh(bench, name, division, quads) if shutil.which("gmsh") else []
    runs = {}
    for _ in range(bench.repeat):
        for threads in (1, 2):
            runs.setdefault(f"quarry {threads}", []).append(bench.mesh(name, division, f"speed_{threads}", threads)[0])
        for row in peers:
            if "command" in row:
                runs.setdefault(row["way"], []).append(run(row["command"], bench.folder, 300))
                say(f"gmsh, {row['way']}: {runs[row['way']][-1].wall:.2f} s")
    medians = {key: median_run(done) for key, done in runs.items()}
    for threads in (1, 2):
        job = load_json(bench.path(name, division, f"speed_{threads}.json"))
        medians[f"quarry {threads}"].peak = job["peak_memory_bytes"]
    for row in peers:
        row.pop("command", None)
        if row["way"] in medians:
            row.update(vars_of(medians[row["way"]]))
    return {"map": name, "division": division, "ours": facts(first, report), "quads": quads,
            "one": vars_of(medians["quarry 1"]), "two": vars_of(medians["quarry 2"]), "gmsh": peers}


def vars_of(done: Run):
    return {"wall": done.wall, "cpu": done.cpu, "peak": done.peak, "code": done.code}


def table_e(bench):
    rows = []
    for division in (300,) if bench.quick else (1200, 2400):
        for threads in (1, 2):
            done, mesh, report = bench.mesh("kb11_traces", division, f"large_{threads}", threads)
            row = {"division": division, "threads": threads, **facts(done, report)}
            if done.code == 0:
                row["digest"] = digest(mesh)
                os.remove(mesh)
            rows.append(row)
    return rows


TABLES = {"A": table_a, "B": table_b, "C": table_c, "D": table_d, "E": table_e, "F": table_f, "G": table_g}


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", default="../shared/data")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--tables", default="".join(TABLES))
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--keep")
    parser.add_argument("--out", default="docs/results.md")
    arguments = parser.parse_args()
    if set(arguments.tables) - set(TABLES):
        parser.error(f"--tables {arguments.tables}: letters of {''.join(TABLES)}")
    if not arguments.keep:
        arguments.keep = "out/maps_quick.json" if arguments.quick else "out/maps.json"
    return arguments


def main():
    arguments = parse()
    kept = load_json(arguments.keep) if os.path.exists(arguments.keep) else {}
    kept["machine"] = machine_text()
    busy = os.getloadavg()[0]
    os.makedirs(os.path.dirname(arguments.keep) or ".", exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder)
        if set("AD") & set(arguments.tables):
            kept["repeat"] = bench.repeat
        for letter in arguments.tables:
            say(f"table {letter}")
            kept[letter] = TABLES[letter](bench)
            kept.setdefault("load", {})[letter] = busy
            with open(arguments.keep, "w") as file:
                json.dump(kept, file, indent=1)
    if arguments.quick:
        print(page.page_text(kept, ""))
    else:
        page.write(arguments.out, kept)
        say(f"wrote {arguments.out}")


if __name__ == "__main__":
    main()
