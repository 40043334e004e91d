#!/usr/bin/python3
"""Says how far the irregular vertices of a quad mesh are from what its lines demand, as JSON.

  charges.py MESH.msh [--chords]

The mesh is cut open along its line elements. The charge of a vertex is the number of faces that it should have less the
number that it has: 4 inside, on lines and rims the nearest number of right angles, at least 1, in each sector. No
operation inside a cell between lines changes the sum over the cell, so that a cell of charge c keeps at least |c|
(Gauss-Bonnet).

demanded    the sum of |charge| over the cells
charge      the sum of |charge| over the vertices: what the mesh has
--chords    collapses of whole chords would change the counts on lines, and may join vertices of opposite charge. After
            halving these are two steps apart, so two chords side by side go together. Of all pairs of chords with
            such vertices: how many would lower the sum of squares, how many of them join no two fixed vertices of
            lines, and the faces that each of those takes away.

It shares no code with quarry. Needs numpy.
"""
import argparse
import json
from collections import defaultdict

import numpy as np

from msh_file import cross, read_msh


class Union:
    def __init__(self):
        self.parent = {}

    def find(self, x):
        root = x
        while self.parent.get(root, root) != root:
            root = self.parent[root]
        while x != root:
            self.parent[x], x = root, self.parent.get(x, x)
        return root

    def join(self, a, b):
        a, b = self.find(a), self.find(b)
        if a != b:
            self.parent[b] = a


class CutOpen:
    """Quads, who lies across which edge, the cells between lines, and the sectors: classes of corners 4 f + k."""

    def __init__(self, points, lines, quads):
        self.points, self.quads = points, quads.tolist()
        self.lines = {tuple(sorted(edge)) for edge in lines.tolist()}
        sides = defaultdict(list)
        for f, quad in enumerate(self.quads):
            for k in range(4):
                sides[tuple(sorted((quad[k], quad[(k + 1) % 4])))].append((f, k))
        self.across, self.cells, self.sectors = {}, Union(), Union()
        for edge, pair in sides.items():
            if len(pair) != 2:
                continue
            (f, k), (g, m) = pair
            self.across[f, k], self.across[g, m] = (g, m), (f, k)
            if edge not in self.lines:
                self.cells.join(f, g)
                self.sectors.join(4 * f + k, 4 * g + (m + 1) % 4)
                self.sectors.join(4 * f + (k + 1) % 4, 4 * g + m)
        self.bound = {v for edge in self.lines for v in edge}
        self.bound |= {v for edge, pair in sides.items() if len(pair) == 1 for v in edge}
        self.charge = self.charges()

    def charges(self):
        p = self.points[np.array(self.quads)]
        out, back = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
        angle = np.arctan2(cross(out, back), (out * back).sum(axis=-1)).ravel()
        corners = defaultdict(list)
        for c in range(len(angle)):
            corners[self.sectors.find(c)].append(c)
        charge = {}
        for sector, members in corners.items():
            at_line = self.quads[sector // 4][sector % 4] in self.bound
            ideal = max(1, int(angle[members].sum() / (np.pi / 2) + 0.5)) if at_line else 4
            charge[sector] = ideal - len(members)
        return charge

    def fixed(self):
        """Vertices that a line cannot do without: nodes, ends, and bends of more than about 17 degrees."""
        near = defaultdict(list)
        for a, b in self.lines:
            near[a].append(b)
            near[b].append(a)
        fixed = set()
        for v, ends in near.items():
            if len(ends) == 2:
                a, b = self.points[ends[0]] - self.points[v], self.points[ends[1]] - self.points[v]
                if abs(cross(a, b)) <= 0.3 * np.hypot(*a) * np.hypot(*b):
                    continue
            fixed.add(v)
        return fixed


class Chords:
    def __init__(self, mesh):
        self.mesh, self.of, self.rungs = mesh, {}, []
        for f in range(len(mesh.quads)):
            for k in (0, 1):
                if (f, k) not in self.of:
                    self.add(f, k)

    def add(self, f, k):
        number, rungs = len(self.rungs), []
        for way in ((f, k), (f, k + 2)):
            at = way
            while True:
                rungs.append(at)
                g, m = self.mesh.across.get(at, (None, 0))
                at = (g, (m + 2) % 4)
                if g is None or at == way:
                    break
            if g is not None:
                break  # closed
        self.rungs.append(rungs)
        for g, m in rungs:
            self.of[g, m] = self.of[g, (m + 2) % 4] = number

    def candidates(self):
        """Pairs of chords side by side with vertices of opposite charge on their far rails."""
        mesh, found = self.mesh, set()
        charge = lambda f, k: mesh.charge[mesh.sectors.find(4 * f + k % 4)]
        for (f, k), (g, m) in mesh.across.items():
            if charge(f, k + 3) * charge(g, m + 2) < 0 or charge(f, k + 2) * charge(g, m + 3) < 0:
                found.add(tuple(sorted({self.of[f, (k + 1) % 4], self.of[g, (m + 1) % 4]})))
        return sorted(found)

    def collapse(self, numbers, fixed):
        """-> fall of the sum of squares, whether no two fixed vertices are joined, faces taken away."""
        mesh, sectors, vertices = self.mesh, Union(), Union()
        faces = {f for n in numbers for f, _ in self.rungs[n]}
        for n in numbers:
            for f, k in self.rungs[n]:
                for e in (k, (k + 2) % 4):
                    a, b = 4 * f + e, 4 * f + (e + 1) % 4
                    sectors.join(mesh.sectors.find(a), mesh.sectors.find(b))
                    vertices.join(mesh.quads[f][e], mesh.quads[f][(e + 1) % 4])
        joined = defaultdict(list)
        for s in {mesh.sectors.find(4 * f + k) for f in faces for k in range(4)}:
            joined[sectors.find(s)].append(mesh.charge[s])
        gain = sum(sum(q * q for q in group) - sum(group)**2 for group in joined.values())
        bound = [vertices.find(v) for v in {v for f in faces for v in mesh.quads[f]} & fixed]
        return gain, len(set(bound)) == len(bound), len(faces)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("mesh")
    options.add_argument("--chords", action="store_true")
    options = options.parse_args()
    points, lines, triangles, quads = read_msh(options.mesh)
    if len(triangles):
        raise SystemExit("charges.py: the mesh has triangles")
    mesh = CutOpen(points, lines, quads)
    of_cell = defaultdict(int)
    for sector, charge in mesh.charge.items():
        of_cell[mesh.cells.find(sector // 4)] += charge
    result = {"quads": len(quads), "cells": len(of_cell), "charge": sum(map(abs, mesh.charge.values())),
              "demanded": sum(map(abs, of_cell.values()))}
    if options.chords:
        chords, fixed = Chords(mesh), mesh.fixed()
        tried = [chords.collapse(pair, fixed) for pair in chords.candidates()]
        possible = [t for t in tried if t[0] > 0 and t[1]]
        result["chords"] = {"all": len(chords.rungs), "pairs": len(tried), "gain": sum(t[0] > 0 for t in tried),
                            "possible": len(possible), "charge_less": sum(t[0] for t in possible),
                            "faces": sorted(t[2] for t in possible)}
    print(json.dumps(result))


if __name__ == "__main__":
    main()
