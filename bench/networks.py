#!/usr/bin/env python3
"""Fracture networks of growing size, meshed by the command and, on the same cleaned lines, by gmsh and netgen: whole
processes, file to file. Prints tables in Markdown, as they stand in docs/results-networks.md.

usage: networks.py [--quarry build/quarry] [--referee DIR] [--segments 1000,10000,100000] [--repeat 3] [--limit 300]
                   [--peers 10000] [--quick] [--out docs/results-networks.md] [--json FILE] [--compare FILE]

--peers    the largest network that gmsh and netgen are given
--limit    seconds that a run of theirs may take
--quick    of gmsh and netgen the fastest ways alone, which the ratios are with
--json     all figures and ratios, for --compare
--compare  prints the ratios beside those of such a file, and ends with 1 if one fell by more than a fifth
"""
import argparse
import json
import os
import sys
import tempfile

import gmsh_geo
import network_page
import ratios
from gmsh_peer import GMSH_WAYS, gmsh_command, gmsh_size
from jobs import Referee, digest, load_json, machine_text, run, say, source_commit

# H times the root of the number of segments, in a box of 1000: about 120 and 70 quads a segment.
SHAPES = {"1,000 segments": (1000, 105), "10,000": (10000, 145), "100,000": (100000, 145), "1,000,000": (1000000, 290)}
WAYS = (("quads, no clean-up", ("--cleanup", "none")), ("quads", ()), ("triangles", ("--elements", "tri")))
# Triangles of gmsh: what it does, options.
GMSH_TRIANGLES = (("triangles, frontal", {"Algorithm": 6}), ("triangles, Delaunay", {"Algorithm": 5}))
FASTEST = ("each triangle to three quads", "triangles, Delaunay", "triangles")
NETGEN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "netgen_peer.py")
NETGEN_WAYS = (("mostly quads", ["--quads"], "quad"), ("triangles", [], "triangle"))


class Bench:
    def __init__(self, arguments, folder):
        self.arguments, self.folder, self.quarry = arguments, folder, arguments.quarry
        self.referee = Referee(arguments.referee)

    def path(self, name):
        return os.path.join(self.folder, name)

    def mesh(self, lines, size, extra, threads):
        """The best of several runs -> (run, digest of the mesh, report)."""
        out, report = self.path("out.vtu"), self.path("out.json")
        command = [self.quarry, "mesh", lines, "--size", f"{size:.12g}", "-o", out, "--report", report, "--threads",
                   threads, "--quiet", *extra]
        runs = [run(command, self.folder, 7200) for _ in range(self.arguments.repeat)]
        best = min(runs, key=lambda done: (done.code, done.cpu if threads == 1 else done.wall))
        say(f"{os.path.basename(lines)} {' '.join(extra)} on {threads}: {best.cpu:.2f} s of {best.wall:.2f}"
            + ("" if best.code == 0 else f", {best.why}"))
        return best, digest(out) if best.code == 0 else "", load_json(report) if best.code == 0 else None

    def fastest(self, command, runs=()):
        """The best processor time of as many runs as asked for, those given among them, and the largest memory."""
        left = range(self.arguments.repeat - len(runs))
        runs = [*runs, *(run(command, self.folder, self.arguments.limit) for _ in left)]
        return {"cpu": min(each.cpu for each in runs), "peak": max(each.peak for each in runs)}


def measure_ours(bench, label, lines, size):
    for what, extra in WAYS:
        one, first, job = bench.mesh(lines, size, extra, 1)
        if one.code != 0:
            yield {"network": label, "what": what, "error": one.why}
            continue
        two, second, _ = bench.mesh(lines, size, extra, 2)
        quality = job["quality"]
        yield {"network": label, "what": what, "size": size,
               "elements": job["counts"]["quads"] + job["counts"]["triangles"],
               "one": {"cpu": one.cpu, "wall": one.wall}, "two": {"cpu": two.cpu, "wall": two.wall},
               "peak": job["peak_memory_bytes"], "same_bytes": first == second,
               "sj_min": quality["scaled_jacobian"]["min"], "sj_mean": quality["scaled_jacobian"]["mean"],
               "below_0.2": 100 * quality["scaled_jacobian"]["share_below_0.2"],
               "irregular": 100 * quality["valence"]["irregular_share"]}


def peer_error(done):
    return "not done in the time" if done.code == -1 else done.why


def gmsh_runs(bench, clean, size):
    """A row for each way of gmsh on the cleaned lines."""
    ways = [(label, shape, factor, options, "quad") for label, shape, factor, options in GMSH_WAYS
            if shape == "faces" and factor]
    ways += [(label, "faces", 1, options, "triangle") for label, options in GMSH_TRIANGLES]
    for label, shape, factor, options, kind in ways:
        if bench.arguments.quick and label not in FASTEST:
            continue
        geo, target = bench.path("faces.geo"), bench.path("gmsh.msh")
        gmsh_geo.write_geo(clean, geo, size, shape)
        done = run(gmsh_command(geo, target, factor * size, options, False), bench.folder, bench.arguments.limit)
        say(f"gmsh, {label}: {done.cpu:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        row = {"who": "gmsh", "way": label, "kind": kind}
        if done.code != 0:
            yield {**row, "error": peer_error(done)}
            continue
        row["quads"], row["triangles"] = gmsh_size(target)
        if bench.referee.there and kind == "quad":
            quality = bench.referee.quality(target)
            quads = quality["quad"]
            row.update({"sj_min": quads["scaled_jacobian"]["min"], "sj_mean": quads["scaled_jacobian"]["mean"],
                        "below_0.2": quads["sj_below_0p2_pct"], "irregular": quality["valence"]["irregular_pct"]})
        yield {**row, **bench.fastest(gmsh_command(geo, target, factor * size, options, True))}


def netgen_runs(bench, clean, size):
    for label, extra, kind in NETGEN_WAYS:
        if bench.arguments.quick and label not in FASTEST:
            continue
        printed = bench.path("netgen.txt")
        command = ["/usr/bin/python3", NETGEN, clean, bench.path("netgen.vol"), "--size", repr(size), *extra]
        done = run(command, bench.folder, bench.arguments.limit, printed)
        say(f"netgen, {label}: {done.cpu:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        row = {"who": "netgen", "way": label, "kind": kind}
        if done.code != 0:
            yield {**row, "error": peer_error(done)}
            continue
        with open(printed, errors="replace") as file:
            row.update(json.loads(file.read().strip().splitlines()[-1]))
        yield {**row, **bench.fastest(command, [done])}


def peer_runs(bench, label, lines, size):
    clean = bench.path("clean.geojson")
    run([bench.quarry, "clean", lines, "--size", f"{size:.12g}", "-o", clean, "--quiet"], bench.folder)
    for row in [*gmsh_runs(bench, clean, size), *netgen_runs(bench, clean, size)]:
        if "cpu" in row:
            row["elements"] = row["quads"] if row["kind"] == "quad" else row["triangles"]
        yield {"network": label, **row}


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
            ours += measure_ours(bench, label, lines, size)
            if count <= arguments.peers:
                peers += peer_runs(bench, label, lines, size)
            os.remove(lines)
    return {"machine": machine_text(), "commit": source_commit(), "quarry": ours, "peers": peers,
            "ratios": ratios.find_ratios(ours, peers)}


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--segments", default="1000,10000,100000")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--limit", type=int, default=300)
    parser.add_argument("--peers", type=int, default=10000)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--out", default="")
    parser.add_argument("--json", default="")
    parser.add_argument("--compare", default="")
    return parser.parse_args()


def main():
    arguments = parse()
    results = measure(arguments)
    if arguments.json:
        with open(arguments.json, "w") as file:
            json.dump(results, file, indent=1)
            file.write("\n")
    if arguments.compare:
        sys.exit(0 if ratios.compare(results["ratios"], load_json(arguments.compare)["ratios"]) else 1)
    page = network_page.page(results, arguments.repeat, arguments.limit, arguments.quick)
    if not arguments.out:
        print(page)
        return
    with open(arguments.out, "w") as file:
        file.write(page)


if __name__ == "__main__":
    main()
