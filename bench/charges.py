#!/usr/bin/python3
"""Says how far the irregular vertices of a quad mesh are from what its lines demand, as JSON.

  charges.py MESH.msh

The mesh is cut open along its line elements. The charge of a vertex is the number of faces that it should have less the
number that it has: 4 inside, on lines and rims the nearest number of right angles, at least 1, in each sector. No
operation inside a cell between lines changes the sum over the cell, so that a cell of charge c keeps at least |c|
(Gauss-Bonnet).

demanded    the sum of |charge| over the cells
charge      the sum of |charge| over the vertices: what the mesh has

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


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("mesh")
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
    print(json.dumps(result))


if __name__ == "__main__":
    main()
