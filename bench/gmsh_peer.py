"""gmsh on the lines that `quarry clean` wrote: its ways to quadrilaterals only, each run once for counts and quality."""
import os

import gmsh_geo
from jobs import run, say

# gmsh's ways to quadrilaterals only: (what it does, shape of the .geo, edge length as a multiple of H, options). Where
# it splits faces of 2H, its quads have edges of about H. -bin, -v 1 and straight second-order edges save it time.
GMSH_WAYS = (
    ("each triangle to three quads", "faces", 2, {"Algorithm": 5, "SubdivisionAlgorithm": 1, "SecondOrderLinear": 1}),
    ("the same, as many quads as quarry", "faces", 0,
     {"Algorithm": 5, "SubdivisionAlgorithm": 1, "SecondOrderLinear": 1}),
    ("pairs and triangles to four and three", "faces", 2,
     {"Algorithm": 5, "RecombineAll": 1, "RecombinationAlgorithm": 0, "SubdivisionAlgorithm": 1,
      "SecondOrderLinear": 1}),
    ("simple full quad", "faces", 1, {"Algorithm": 6, "RecombineAll": 1, "RecombinationAlgorithm": 2}),
    ("full quad; loses the dead ends, so without them", "backbone", 1,
     {"Algorithm": 6, "RecombineAll": 1, "RecombinationAlgorithm": 3}),
)


def gmsh_command(geo, target, length, options, fast):
    numbers = [part for key, value in options.items() for part in ("-setnumber", "Mesh." + key, str(value))]
    # The checkers read ASCII; the timed runs write binary, which is faster.
    return ["gmsh", "-2", geo, "-setnumber", "h", repr(length), *numbers, "-nt", "1", "-o", target,
            *(["-bin", "-v", "1"] if fast else [])]


def gmsh_size(target):
    """Quads and triangles in a .msh 4.1 in ASCII."""
    counts, inside = {}, False
    with open(target) as file:
        for line in file:
            if line.startswith("$Elements"):
                inside, left = True, -1
            elif line.startswith("$EndElements"):
                break
            elif inside and left < 0:
                left = 0
            elif inside and left == 0:
                _, _, kind, left = map(int, line.split())
                counts[kind] = counts.get(kind, 0) + left
            elif inside:
                left -= 1
    return counts.get(3, 0), counts.get(2, 0)


def prepare_gmsh(bench, name, division, quads):
    """Every way once, in ASCII, for its counts and quality -> rows, and the commands to be timed."""
    size, clean = bench.size(name, division), bench.path("clean.geojson")
    run([bench.quarry, "clean", bench.lines(name), *bench.boundary(name), "--size", f"{size:.12g}", "-o", clean,
         "--quiet"], bench.folder)
    rows = []
    for label, shape, factor, options in GMSH_WAYS:
        geo, target = bench.path(shape + ".geo"), bench.path("gmsh.msh")
        gmsh_geo.write_geo(clean, geo, size, shape)
        # As many quads: they grow with the inverse square of the edge length.
        length = factor * size if factor else 2 * size * (rows[0]["quads"] / quads) ** 0.5
        done = run(gmsh_command(geo, target, length, options, False), bench.folder, 300)
        row = {"way": label, "shape": shape, "length": length / size, "options": options}
        rows.append(row)
        say(f"gmsh, {label}: {done.wall:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        if done.code != 0:
            row["error"] = done.why
            continue
        row["quads"], row["triangles"] = gmsh_size(target)
        if bench.referee.there:
            quality = bench.referee.quality(target)
            row["quality"] = {**quality.get("quad", {}), "irregular_pct": quality["valence"]["irregular_pct"]}
        row["command"] = gmsh_command(geo, target, length, options, True)
    return rows


def mesh_at_count(bench, clean, size, quads, way, tries=3):
    """One of GMSH_WAYS with about as many quads as asked for: the edge length is corrected until they are within 2 %
    -> a row with the path of the mesh and the shift to the lines' coordinates."""
    label, shape, factor, options = way
    geo, target = bench.path("count.geo"), bench.path("gmsh", GMSH_WAYS.index(way), f"{quads}.msh")
    origin = gmsh_geo.write_geo(clean, geo, size, shape)["origin"]
    row = {"way": label, "shape": shape, "options": options, "shift": origin}
    length, nearest = (factor or 1) * size, None
    for _ in range(tries):
        attempt = bench.path("attempt.msh")
        done = run(gmsh_command(geo, attempt, length, options, False), bench.folder, 300)
        say(f"gmsh, {label}: {done.wall:.2f} s" + ("" if done.code == 0 else f", {done.why}"))
        if done.code != 0:
            break
        count, triangles = gmsh_size(attempt)
        off = abs(count / quads - 1)
        if nearest is None or off < nearest:
            nearest = off
            os.replace(attempt, target)
            row.update(quads=count, triangles=triangles, length=length / size, wall=done.wall, cpu=done.cpu,
                       mesh=target)
        if off < 0.02:
            break
        length *= (count / quads) ** 0.5
    return row if "mesh" in row else {**row, "error": done.why}
