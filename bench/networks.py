#!/usr/bin/env python3
"""Fracture networks of growing size, meshed by the command and, on the same cleaned lines, by gmsh and netgen: whole
processes, file to file. Prints tables in Markdown, as they stand in docs/results-networks.md.

usage: networks.py [--quarry build/quarry] [--referee DIR] [--segments 1000,10000,100000] [--maps NAME,... --data DIR]
                   [--repeat 3] [--limit 300] [--peers 10000] [--quick] [--out docs/results-networks.md] [--json FILE]
                   [--into FILE] [--compare FILE]

--maps     real maps as well, at a 600th of their longer side: of the files of that folder, planar/NAME.lines.geojson
--peers    the largest network that gmsh and netgen are given
--limit    seconds that a run of theirs may take
--quick    of gmsh and netgen the fastest ways alone, which the ratios are with
--out      a page whose text below the tables is kept; without it the tables are printed
--json     all figures and ratios, for --compare
--into     such a file whose rows of the same networks and ways are replaced: the page and --json have all of both
--compare  prints the ratios beside those of such a file, and ends with 1 if one fell by more than a fifth or is missing,
           a run failed, lines were lost, or two threads wrote other bytes than one
"""
import argparse
import json
import os
import sys
import tempfile

import network_page
import page
import ratios
from jobs import Referee, call_checker, digest, load_json, machine_text, run, say, source_commit
from maps import box_of
from network_peers import KEPT_WITHIN, figures_of, kept_share, peer_rows

# H times the root of the number of segments, in a box of 1000: about 120 and 70 quads a segment.
SHAPES = {"1,000 segments": (1000, 105), "10,000": (10000, 145), "100,000": (100000, 145), "1,000,000": (1000000, 290)}
MAP_DIVISION = 600
WAYS = (("quads, no clean-up", ("--cleanup", "none")), ("quads", ()), ("triangles", ("--elements", "tri")))
HERE = os.path.dirname(os.path.abspath(__file__))


class Bench:
    def __init__(self, arguments, folder):
        self.arguments, self.folder, self.quarry = arguments, folder, arguments.quarry
        self.referee = Referee(arguments.referee)

    def path(self, name):
        return os.path.join(self.folder, name)

    def mesh(self, lines, size, extra, threads):
        """The best of several runs, or one that failed -> (run, digest of the mesh, report)."""
        out, report = self.path("out.vtu"), self.path("out.json")
        command = [self.quarry, "mesh", lines, "--size", f"{size:.12g}", "-o", out, "--report", report, "--threads",
                   threads, "--quiet", *extra]
        runs = [run(command, self.folder, 7200) for _ in range(self.arguments.repeat)]
        best = min(runs, key=lambda done: (done.code == 0, done.cpu if threads == 1 else done.wall))
        say(f"{os.path.basename(lines)} {' '.join(extra)} on {threads}: {best.cpu:.2f} s of {best.wall:.2f}"
            + ("" if best.code == 0 else f", {best.why}"))
        return best, digest(out) if best.code == 0 else "", load_json(report) if best.code == 0 else None

    def clean(self, lines, size):
        target = self.path("clean.geojson")
        run([self.quarry, "clean", lines, "--size", f"{size:.12g}", "-o", target, "--quiet"], self.folder)
        return target

    def check(self, script, *arguments):
        return call_checker(self.referee.python, os.path.join(HERE, script), *arguments) if self.referee.python else None

    def as_msh(self, mesh, target):
        """The same mesh as a .msh 4.1 in ASCII, which the checks read."""
        if os.path.exists(target):
            os.remove(target)
        run([self.quarry, "convert", mesh, target, "--quiet"], self.folder)
        return target


def measure_ours(bench, label, lines, clean, size):
    for what, extra in WAYS:
        one, first, job = bench.mesh(lines, size, extra, 1)
        if one.code != 0:
            yield {"network": label, "what": what, "error": one.why}
            continue
        kept = kept_share(bench, bench.as_msh(bench.path("out.vtu"), bench.path("out.msh")), clean, size)
        two, second, _ = bench.mesh(lines, size, extra, 2)
        if two.code != 0:
            yield {"network": label, "what": what, "error": two.why}
            continue
        yield {"network": label, "what": what, "size": size,
               "elements": job["counts"]["quads"] + job["counts"]["triangles"],
               "one": {"cpu": one.cpu, "wall": one.wall}, "two": {"cpu": two.cpu, "wall": two.wall},
               "peak": job["peak_memory_bytes"], "same_bytes": first == second, "kept": kept,
               **figures_of(job["quality"])}


def quads_of(ours, label):
    """How many quads quarry made of a network by default; None if it made none."""
    return next((row["elements"] for row in ours if row["network"] == label and row["what"] == "quads"
                 and "error" not in row), None)


def measure(arguments):
    wanted = {int(word) for word in arguments.segments.split(",")}
    ours, peers = [], []
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder)
        for label, (count, density) in SHAPES.items():
            if count not in wanted:
                continue
            lines, size = bench.path(f"{count}.geojson"), density / count**0.5
            run([bench.quarry, "generate", "fractures", "--count", count, "-o", lines, "-q"], folder)
            clean = bench.clean(lines, size)
            ours += measure_ours(bench, label, lines, clean, size)
            if count <= arguments.peers:
                peers += peer_rows(bench, label, clean, size, quads_of(ours, label))
            os.remove(lines)
        for name in filter(None, arguments.maps.split(",")):
            lines = os.path.join(arguments.data, "planar", name + ".lines.geojson")
            x0, y0, x1, y1 = box_of(lines)
            size = max(x1 - x0, y1 - y0) / MAP_DIVISION
            clean = bench.clean(lines, size)
            ours += [{**row, "map": True} for row in measure_ours(bench, name, lines, clean, size)]
            peers += peer_rows(bench, name, clean, size, quads_of(ours, name))
    made = f"{source_commit()}, best of {arguments.repeat}"
    return {"machine": machine_text(), "near": KEPT_WITHIN, "quarry": [{**row, "made": made} for row in ours],
            "peers": [{**row, "made": made} for row in peers]}


def key_of(row):
    """What a row is about. That gmsh has as many quads stands in brackets after the way."""
    return row["network"], row.get("who"), row.get("way", row.get("what")).split(" (")[0]


def with_rows_of(old, new):
    """All rows of both, the new ones in place of old ones about the same, in the order of the networks."""
    names = dict.fromkeys([*SHAPES, *(row["network"] for row in old["quarry"] + new["quarry"])])
    order = {name: i for i, name in enumerate(names)}
    joined = {**old, **new}
    for kind in ("quarry", "peers"):
        rows = {key_of(row): row for row in old[kind] + new[kind]}
        joined[kind] = sorted(rows.values(), key=lambda row: order[row["network"]])
    return joined


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--segments", default="1000,10000,100000")
    parser.add_argument("--maps", default="")
    parser.add_argument("--data", default="../shared/data")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--limit", type=int, default=300)
    parser.add_argument("--peers", type=int, default=10000)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--out", default="")
    parser.add_argument("--json", default="")
    parser.add_argument("--into", default="")
    parser.add_argument("--compare", default="")
    return parser.parse_args()


def main():
    arguments = parse()
    measured = measure(arguments)
    results = with_rows_of(load_json(arguments.into), measured) if arguments.into else measured
    results["ratios"] = ratios.find_ratios(results["quarry"], results["peers"])
    results["rates"] = ratios.find_rates(results["quarry"])
    if arguments.json:
        with open(arguments.json, "w") as file:
            json.dump(results, file, indent=1)
            file.write("\n")
    failures = list(ratios.failures(measured["quarry"]))
    for failure in failures:
        say(failure)
    if arguments.compare:
        networks = {row["network"] for row in measured["quarry"]}
        good = ratios.compare(results["ratios"], load_json(arguments.compare)["ratios"], networks)
        sys.exit(0 if good and not failures else 1)
    if arguments.out:
        page.write(arguments.out, results, network_page.page_text)
    else:
        print(network_page.page_text(results, ""))


if __name__ == "__main__":
    main()
