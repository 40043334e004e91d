#!/usr/bin/python3
"""Turns the lines that `quarry clean` wrote into gmsh's .geo, so that a peer meshes exactly the same lines.

  gmsh_geo.py CLEAN.geojson OUT.geo --size H [--shape faces|backbone|embedded] [--groups]

faces      one plane surface for each enclosed face, dead ends embedded in the face that they lie in (the whole job)
backbone   the same without dead ends and without what hangs in a face (an easier job than quarry's)
embedded   one plane surface within the outline, every other line embedded
--groups   lines, outline and faces become physical groups

The lines must be noded, as `quarry clean` leaves them: they meet at equal coordinates only. Outline lines are those whose
property `kind` is "outline". Needs the standard library alone.
"""
import argparse
import json
import math
from collections import defaultdict


def read_graph(path):
    """-> points [(x, y)], edges [(a, b)] once each, and for each edge whether it is outline."""
    index, points, edges = {}, [], {}

    def number(position):
        key = tuple(position[:2])
        if key not in index:
            index[key] = len(points)
            points.append(key)
        return index[key]

    with open(path) as file:
        features = json.load(file)["features"]
    for feature in features:
        outline = feature["properties"].get("kind") == "outline"
        chain = [number(p) for p in feature["geometry"]["coordinates"]]
        for a, b in zip(chain, chain[1:]):
            key = (min(a, b), max(a, b))
            if a != b:
                edges[key] = edges.get(key, False) or outline
    return points, list(edges), list(edges.values())


def without_dead_ends(points, edges, keep):
    """Clears keep[] of the edges that hang on one end, again and again."""
    at = defaultdict(set)
    for k, (a, b) in enumerate(edges):
        if keep[k]:
            at[a].add(k)
            at[b].add(k)
    stack = [v for v, around in at.items() if len(around) == 1]
    while stack:
        v = stack.pop()
        if len(at[v]) != 1:
            continue
        k = at[v].pop()
        keep[k] = False
        other = edges[k][0] if edges[k][1] == v else edges[k][1]
        at[other].discard(k)
        if len(at[other]) == 1:
            stack.append(other)


def trace_loops(points, edges, keep):
    """Closed walks, their face on the left, as lists of signed edge numbers from 1; one walk meets a bridge twice."""
    around = defaultdict(list)
    for k, (a, b) in enumerate(edges):
        if keep[k]:
            ax, ay, bx, by = *points[a], *points[b]
            around[a].append((math.atan2(by - ay, bx - ax), b, k + 1))
            around[b].append((math.atan2(ay - by, ax - bx), a, -(k + 1)))
    after = {}
    for out in around.values():
        out.sort()
        for i, (_, _, leaving) in enumerate(out):
            after[-leaving] = out[i - 1][2]  # arriving along -leaving, the next to the right leaves
    loops, seen = [], set()
    for start in sorted(after):
        if start in seen:
            continue
        loop, here = [], start
        while here not in seen:
            seen.add(here)
            loop.append(here)
            here = after[here]
        loops.append(loop)
    return loops


def corners(points, edges, loop):
    return [points[edges[abs(k) - 1][0 if k > 0 else 1]] for k in loop]


def signed_area(ring):
    x0, y0 = ring[0]
    return 0.5 * sum((px - x0) * (qy - y0) - (qx - x0) * (py - y0)
                     for (px, py), (qx, qy) in zip(ring, ring[1:] + ring[:1]))


def holds(ring, x, y):
    inside = False
    for (px, py), (qx, qy) in zip(ring, ring[1:] + ring[:1]):
        if (py > y) != (qy > y) and x < px + (y - py) * (qx - px) / (qy - py):
            inside = not inside
    return inside


class Faces:
    """The enclosed faces, smallest first, each with its ring, holes and what is embedded."""

    def __init__(self, points, edges, keep, loops):
        rings = [(signed_area(corners(points, edges, loop)), loop) for loop in loops]
        outer = sorted((area, loop) for area, loop in rings if area > 0)
        self.loops = [loop for _, loop in outer]
        self.rings = [corners(points, edges, loop) for loop in self.loops]
        self.boxes = [(min(x for x, _ in r), min(y for _, y in r), max(x for x, _ in r), max(y for _, y in r))
                      for r in self.rings]
        self.holes = defaultdict(list)
        self.inside = defaultdict(list)
        self.make_cells(points)
        for _, loop in (r for r in rings if r[0] < 0):
            ring = corners(points, edges, loop)
            own = set(map(abs, loop))
            face = self.find(*ring[0], own)
            if face is not None:
                self.holes[face].append(loop)

    def make_cells(self, points):
        """A grid of about as many cells as faces, in each the faces whose box meets it, smallest first."""
        self.corner = [min(p[i] for p in points) for i in (0, 1)]
        side = max(max(p[i] for p in points) - self.corner[i] for i in (0, 1))
        self.step = side / math.ceil(math.sqrt(len(self.rings) + 1))
        self.in_cell = defaultdict(list)
        for i, (x0, y0, x1, y1) in enumerate(self.boxes):
            (c0, r0), (c1, r1) = self.cell(x0, y0), self.cell(x1, y1)
            for column in range(c0, c1 + 1):
                for row in range(r0, r1 + 1):
                    self.in_cell[column, row].append(i)

    def cell(self, x, y):
        return tuple(math.floor((at - corner) / self.step) for at, corner in zip((x, y), self.corner))

    def find(self, x, y, foreign=frozenset()):
        """The smallest face around a point; not one that has an edge among `foreign` (its own other side)."""
        for i in self.in_cell.get(self.cell(x, y), ()):
            x0, y0, x1, y1 = self.boxes[i]
            if x0 <= x <= x1 and y0 <= y <= y1 and holds(self.rings[i], x, y):
                if not foreign or foreign.isdisjoint(map(abs, self.loops[i])):
                    return i
        return None


def bridges(edges, loops, keep):
    """Edges that one loop walks in both directions: they bound no face."""
    found = []
    for loop in loops:
        here = set(loop)
        found += [k - 1 for k in here if k > 0 and -k in here]
    return found


def origin_of(points):
    return [math.floor(min(p[i] for p in points)) for i in (0, 1)]


def write_points_and_lines(out, points, edges, keep, size):
    """Coordinates from a rounded origin: gmsh tells points apart relative to their distance from (0, 0)."""
    x0, y0 = origin_of(points)
    out.write(f"If (!Exists(h))\n h = {size:.17g};\nEndIf\n"  # gmsh -setnumber h H goes before
              "Mesh.CharacteristicLengthMax = h;\nMesh.CharacteristicLengthFromPoints = 0;\n"
              "Mesh.CharacteristicLengthExtendFromBoundary = 0;\n")
    live = {v for k, edge in enumerate(edges) if keep[k] for v in edge}
    out.writelines(f"Point({v + 1}) = {{{points[v][0] - x0:.17g},{points[v][1] - y0:.17g},0}};\n" for v in sorted(live))
    out.writelines(f"Line({k + 1}) = {{{a + 1},{b + 1}}};\n" for k, (a, b) in enumerate(edges) if keep[k])


def write_faces(out, faces):
    count = 0
    for i, loop in enumerate(faces.loops):
        numbers = []
        for ring in [loop] + faces.holes[i]:
            count += 1
            numbers.append(str(count))
            out.write(f"Curve Loop({count}) = {{{','.join(map(str, ring))}}};\n")
        out.write(f"Plane Surface({i + 1}) = {{{','.join(numbers)}}};\n")
    # All of these after all surfaces: gmsh synchronises its model at each change from one kind to the other.
    for i in sorted(faces.inside):
        out.write(f"Line{{{','.join(str(k + 1) for k in faces.inside[i])}}} In Surface{{{i + 1}}};\n")


def write_groups(out, faces, keep, outline):
    """Lines and outline as groups of their own, which other tools find in the mesh as tagged edges."""
    for name, wanted in (("lines", False), ("outline", True)):
        numbers = [str(k + 1) for k, kept in enumerate(keep) if kept and outline[k] == wanted]
        if numbers:
            out.write(f"Physical Curve(\"{name}\") = {{{','.join(numbers)}}};\n")
    out.writelines(f"Physical Surface({i + 1}) = {{{i + 1}}};\n" for i in range(len(faces.loops)))


def write_geo(source, target, size, shape, groups=False):
    points, edges, outline = read_graph(source)
    keep = list(outline) if shape == "embedded" else [True] * len(edges)
    without_dead_ends(points, edges, keep)
    loops = trace_loops(points, edges, keep)
    for k in bridges(edges, loops, keep):
        keep[k] = False
    without_dead_ends(points, edges, keep)
    loops = trace_loops(points, edges, keep)
    faces = Faces(points, edges, keep, loops)
    if shape != "backbone":
        for k, (a, b) in enumerate(edges):
            if not keep[k]:
                face = faces.find((points[a][0] + points[b][0]) / 2, (points[a][1] + points[b][1]) / 2)
                if face is not None:
                    faces.inside[face].append(k)
                    keep[k] = True
    with open(target, "w") as out:
        write_points_and_lines(out, points, edges, keep, size)
        write_faces(out, faces)
        if groups:
            write_groups(out, faces, keep, outline)
    return {"origin": origin_of(points), "points": len(points), "edges": len(edges), "edges_kept": sum(keep),
            "faces": len(faces.loops)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("target")
    parser.add_argument("--size", type=float, required=True)
    parser.add_argument("--shape", choices=("faces", "backbone", "embedded"), default="faces")
    parser.add_argument("--groups", action="store_true")
    a = parser.parse_args()
    print(json.dumps(write_geo(a.source, a.target, a.size, a.shape, a.groups)))


if __name__ == "__main__":
    main()
