"""gmsh and netgen on the lines that `quarry clean` wrote: the rows of bench/networks.py that are not quarry's own."""
import json
import os

import gmsh_geo
from gmsh_peer import GMSH_WAYS, gmsh_command, gmsh_size
from jobs import load_json, run, say

# gmsh's pairing of triangles with nothing after it: quadrilaterals alone only where every triangle finds a partner.
PLAIN_WAYS = (
    ("simple recombination", "faces", 1, {"Algorithm": 6, "RecombineAll": 1, "RecombinationAlgorithm": 0}),
    ("blossom recombination", "faces", 1, {"Algorithm": 6, "RecombineAll": 1, "RecombinationAlgorithm": 1}),
    ("full quad", "faces", 1, {"Algorithm": 6, "RecombineAll": 1, "RecombinationAlgorithm": 3}),
)
# Triangles of gmsh: what it does, options.
GMSH_TRIANGLES = (("triangles, frontal", {"Algorithm": 6}), ("triangles, Delaunay", {"Algorithm": 5}))
FASTEST = ("each triangle to three quads", "the same, as many quads as quarry", "triangles, Delaunay", "triangles")
NETGEN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "netgen_peer.py")
NETGEN_WAYS = (("mostly quads", ["--quads"], "quad"), ("triangles", [], "triangle"))
# An edge covers a line within this share of the element size: as far as one may lie from its line, and within which
# narrow wedges between lines are closed.
KEPT_WITHIN = 0.05
# How near to quarry's count one of gmsh's is that has as many quads, and how often its edge is corrected for it.
SAME_COUNT, CORRECTIONS = 0.02, 4


def why_not(done, limit):
    if done.code == -1:
        return f"not in {limit} s"
    # gmsh ends with a summary of its errors.
    first = next((line for line in done.errors.splitlines() if line.startswith("Error ")), None)
    return f"exit {done.code}: {' '.join(first.split())[:120]}" if first else done.why


def best_of(bench, command, runs=()):
    """The best processor time and the largest memory of as many runs as asked for, those given among them; an error if
    one of them did not come to its end."""
    left = range(bench.arguments.repeat - len(runs))
    runs = [*runs, *(run(command, bench.folder, bench.arguments.limit) for _ in left)]
    failed = next((each for each in runs if each.code != 0), None)
    if failed:
        return {"error": why_not(failed, bench.arguments.limit)}
    return {"cpu": min(each.cpu for each in runs), "peak": max(each.peak for each in runs)}


def kept_share(bench, mesh, clean, size, shift=(0, 0)):
    """How much of the cleaned lines' length lies under edges of a .msh, in %; None where it cannot be measured."""
    found = bench.check("kept_lines.py", mesh, clean, "--near", repr(KEPT_WITHIN * size), "--shift", *map(repr, shift))
    return found and found.get("covered_pct")


def figures_of(quality):
    """A row's figures of the elements, of what `quarry quality --json` and reports say."""
    shapes = quality["scaled_jacobian"]
    return {"sj_min": shapes["min"], "sj_mean": shapes["mean"], "below_0.2": 100 * shapes["share_below_0.2"],
            "irregular": 100 * quality["valence"]["irregular_share"]}


def measured_figures(bench, mesh):
    """The same of a mesh file; none if quarry does not read it."""
    printed = bench.path("quality.json")
    done = run([bench.quarry, "quality", mesh, "--json"], bench.folder, output=printed)
    return figures_of(load_json(printed)) if done.code == 0 else {}


def gmsh_ways():
    ways = [(*way, "quad") for way in (*GMSH_WAYS, *PLAIN_WAYS) if way[1] == "faces"]
    return ways + [(label, "faces", 1, options, "triangle") for label, options in GMSH_TRIANGLES]


def at_count(mesh, factor, count, quads):
    """mesh(factor) again and again until it has about so many quads -> (run, factor). count: with this factor."""
    done = None
    for _ in range(CORRECTIONS):
        # They grow with the inverse square of the edge length, more slowly where lines are near to each other.
        factor *= (count / quads) ** 0.5
        done, count = mesh(factor)
        if done.code != 0 or abs(count / quads - 1) < SAME_COUNT:
            break
    return done, factor


def gmsh_rows(bench, clean, size, quads):
    """A row for each way of gmsh on the cleaned lines; quads: how many quarry made, or None if it made none."""
    geo, target = bench.path("faces.geo"), bench.path("gmsh.msh")
    shift = gmsh_geo.write_geo(clean, geo, size, "faces")["origin"]
    first = None
    for label, _, factor, options, kind in gmsh_ways():
        if bench.arguments.quick and label not in FASTEST or not (factor or first and quads):
            continue

        def mesh(edge):
            done = run(gmsh_command(geo, target, edge * size, options, False), bench.folder, bench.arguments.limit)
            say(f"gmsh, {label}: {done.cpu:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
            return done, gmsh_size(target)[0] if done.code == 0 else 0

        if factor:
            done = mesh(factor)[0]
        else:
            done, factor = at_count(mesh, 2, first, quads)
            label += f" (h = {factor:.2f} H)"
        row = {"who": "gmsh", "way": label, "kind": kind}
        if done.code != 0:
            yield {**row, "error": why_not(done, bench.arguments.limit)}
            continue
        row["quads"], row["triangles"] = gmsh_size(target)
        first = first or row["quads"]
        if bench.referee.there and kind == "quad":
            quality = bench.referee.quality(target)
            shapes = quality["quad"]
            row.update({"sj_min": shapes["scaled_jacobian"]["min"], "sj_mean": shapes["scaled_jacobian"]["mean"],
                        "below_0.2": shapes["sj_below_0p2_pct"], "irregular": quality["valence"]["irregular_pct"]})
        elif kind == "triangle":
            row.update(measured_figures(bench, target))
        row["kept"] = kept_share(bench, target, clean, size, shift)
        yield {**row, **best_of(bench, gmsh_command(geo, target, factor * size, options, True))}


def netgen_rows(bench, clean, size):
    for label, extra, kind in NETGEN_WAYS:
        if bench.arguments.quick and label not in FASTEST:
            continue
        printed, target, exported = bench.path("netgen.txt"), bench.path("netgen.vol"), bench.path("exported.msh")
        command = ["/usr/bin/python3", NETGEN, clean, target, "--size", repr(size), *extra]
        done = run(command, bench.folder, bench.arguments.limit, printed)
        say(f"netgen, {label}: {done.cpu:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        row = {"who": "netgen", "way": label, "kind": kind}
        if done.code != 0:
            yield {**row, "error": why_not(done, bench.arguments.limit)}
            continue
        with open(printed, errors="replace") as file:
            row.update(json.loads(file.read().strip().splitlines()[-1]))
        run(["/usr/bin/python3", NETGEN, target, exported], bench.folder)
        mesh = bench.as_msh(exported, bench.path("netgen.msh"))
        row.update(measured_figures(bench, mesh))
        row["kept"] = kept_share(bench, mesh, clean, size)
        yield {**row, **best_of(bench, command, [done])}


def peer_rows(bench, label, clean, size, quads):
    for row in [*gmsh_rows(bench, clean, size, quads), *netgen_rows(bench, clean, size)]:
        if "cpu" in row:
            row["elements"] = row["quads"] if row["kind"] == "quad" else row["triangles"]
        yield {"network": label, **row}
