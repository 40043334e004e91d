#!/usr/bin/env python3
"""Fracture networks of growing size, meshed by the command and, on the same cleaned lines, by gmsh: whole processes, file
to file. Prints tables in Markdown, as they stand in docs/results-networks.md.

usage: networks.py [--quarry build/quarry] [--referee DIR] [--segments 1000,10000,100000] [--repeat 3] [--limit 300]
                   [--peers 10000] [--out docs/results-networks.md]

--peers   the largest network that gmsh is given
--limit   seconds that a run of gmsh may take
"""
import argparse
import os
import tempfile

import gmsh_geo
from gmsh_peer import GMSH_WAYS, gmsh_command, gmsh_size
from jobs import Referee, digest, load_json, machine_text, run, say, source_commit

# H times the root of the number of segments, in a box of 1000: about 120 and 70 quads a segment.
SHAPES = {"1,000 segments": (1000, 105), "10,000": (10000, 145), "100,000": (100000, 145), "1,000,000": (1000000, 290)}
WAYS = (("quads, no clean-up", ("--cleanup", "none")), ("quads", ()), ("triangles", ("--elements", "tri")))
# Triangles of gmsh: what it does, options.
GMSH_TRIANGLES = (("triangles, frontal", {"Algorithm": 6}), ("triangles, Delaunay", {"Algorithm": 5}))

PAGE = """# Networks of growing size

Made by `bench/networks.py`, which anyone can rerun; do not edit. Fractures drawn by `quarry generate fractures --count N`
in a box of 1000, {size}. Whole processes, file to file, seconds of processor time (and of the clock in brackets), the best
of {repeat}. gmsh meshes the lines that `quarry clean` wrote, face by face of the arrangement, to an edge that gives about as
many elements; the ways are those of [results.md](results.md). A run of it ends after {limit} s. Machine: {machine}.
Sources as of {commit}.

## quarry

| network | what | H | elements | 1 thread s | elements/s | us an element | 2 threads s | 1 by 2, clock | peak MB | bytes an element above 50 MB | SJ min | SJ mean | % irregular | same bytes 1, 2 |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|
{ours}

## gmsh beside it

{peers}
"""

PEER_HEADING = """| network | gmsh | elements | s | elements/s | quarry's, of its kind, are so many times as fast: without clean-up | with | triangles left | SJ min | SJ mean | % irregular |
|---|---|---|---|---|---|---|---|---|---|---|"""


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


def measure_ours(bench, label, lines, size):
    rows = []
    for what, extra in WAYS:
        done, first, job = bench.mesh(lines, size, extra, 1)
        if done.code != 0:
            rows.append({"network": label, "what": what, "error": done.why})
            continue
        two, second, _ = bench.mesh(lines, size, extra, 2)
        rows.append({"network": label, "what": what, "size": size, "job": job, "one": done, "two": two,
                     "same": first == second,
                     "count": job["counts"]["quads"] + job["counts"]["triangles"]})
    return rows


def ours_row(row):
    if "error" in row:
        return f"| {row['network']} | {row['what']} | {row['error']} |" + " |" * 12
    count, one, two, quality = row["count"], row["one"], row["two"], row["job"]["quality"]
    peak = row["job"]["peak_memory_bytes"]
    return (f"| {row['network']} | {row['what']} | {row['size']:.3g} | {count:,} | {one.cpu:.2f} ({one.wall:.2f}) | "
            f"{count / one.cpu:,.0f} | {1e6 * one.cpu / count:.2f} | {two.cpu:.2f} ({two.wall:.2f}) | "
            f"{one.wall / two.wall:.2f} | {peak / 1e6:.0f} | {max(0, peak - 5e7) / count:.0f} | "
            f"{quality['scaled_jacobian']['min']:.3f} | {quality['scaled_jacobian']['mean']:.4f} | "
            f"{100 * quality['valence']['irregular_share']:.2f} | {'yes' if row['same'] else '**no**'} |")


def peer_runs(bench, lines, size, quads):
    """(way, elements, run, quality) of each way of gmsh on the cleaned lines."""
    clean = bench.path("clean.geojson")
    run([bench.quarry, "clean", lines, "--size", f"{size:.12g}", "-o", clean, "--quiet"], bench.folder)
    ways = [(label, shape, factor or 2, options, "quad") for label, shape, factor, options in GMSH_WAYS
            if shape == "faces" and factor]
    ways += [(label, "faces", 1, options, "triangle") for label, options in GMSH_TRIANGLES]
    for label, shape, factor, options, kind in ways:
        geo, target = bench.path("faces.geo"), bench.path("gmsh.msh")
        gmsh_geo.write_geo(clean, geo, size, shape)
        done = run(gmsh_command(geo, target, factor * size, options, False), bench.folder, bench.arguments.limit)
        say(f"gmsh, {label}: {done.cpu:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        if done.code != 0:
            yield {"way": label, "kind": kind, "error": "not done in the time" if done.code == -1 else done.why}
            continue
        counts = gmsh_size(target)
        row = {"way": label, "kind": kind, "quads": counts[0], "triangles": counts[1]}
        if bench.referee.there and kind == "quad":
            quality = bench.referee.quality(target)
            jacobian = quality["quad"]["scaled_jacobian"]
            row.update(sj_min=jacobian["min"], sj_mean=jacobian["mean"], irregular=quality["valence"]["irregular_pct"])
        fast = [run(gmsh_command(geo, target, factor * size, options, True), bench.folder, bench.arguments.limit)
                for _ in range(bench.arguments.repeat)]
        row["cpu"] = min(each.cpu for each in fast)
        yield row


def peer_row(network, row, ours):
    if "error" in row:
        return f"| {network} | {row['way']} | {row['error']} |" + " |" * 8
    count = row["quads"] if row["kind"] == "quad" else row["triangles"]
    rate = count / row["cpu"]
    times = [f"{each['count'] / each['one'].cpu / rate:.1f}" if each and "one" in each else "" for each in
             ([ours["quads, no clean-up"], ours["quads"]] if row["kind"] == "quad" else [ours["triangles"], None])]
    shape = [f"{row[key]:.4g}" if key in row else "" for key in ("sj_min", "sj_mean", "irregular")]
    left = f"{row['triangles']:,}" if row["kind"] == "quad" else ""
    return (f"| {network} | {row['way']} | {count:,} | {row['cpu']:.2f} | {rate:,.0f} | {times[0]} | {times[1]} | {left} | "
            + " | ".join(shape) + " |")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--segments", default="1000,10000,100000")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--limit", type=int, default=300)
    parser.add_argument("--peers", type=int, default=10000)
    parser.add_argument("--out", default="")
    return parser.parse_args()


def main():
    arguments = parse()
    wanted = {int(word) for word in arguments.segments.split(",")}
    ours_rows, peer_rows = [], []
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder)
        for label, (count, density) in SHAPES.items():
            if count not in wanted:
                continue
            lines, size = bench.path(f"{count}.geojson"), density / count**0.5
            run([bench.quarry, "generate", "fractures", "--count", count, "-o", lines, "-q"], folder)
            rows = measure_ours(bench, label, lines, size)
            ours_rows += map(ours_row, rows)
            ours = {row["what"]: row for row in rows}
            if count <= arguments.peers and "count" in ours["quads"]:
                peer_rows += [peer_row(label, row, ours) for row in peer_runs(bench, lines, size, ours["quads"]["count"])]
            os.remove(lines)
    page = PAGE.format(size="with lengths by a power law and two sets of directions", repeat=arguments.repeat,
                       limit=arguments.limit, machine=machine_text(), commit=source_commit(), ours="\n".join(ours_rows),
                       peers="\n".join([PEER_HEADING, *peer_rows]) if peer_rows else "Not run.")
    if not arguments.out:
        print(page)
        return
    with open(arguments.out, "w") as file:
        file.write(page)


if __name__ == "__main__":
    main()
