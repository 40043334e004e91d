#!/usr/bin/python3
"""Lists the poor quads of a mesh and says which of them the lines force, as JSON.

  poor_faces.py MESH.msh LINES.geojson --near D [--below 0.2] [--aspect 8] [--shift X Y]

LINES       noded lines, as `quarry clean` leaves them
--near D    a vertex this near to a node of the lines is that node
--below S   quads with a smaller scaled Jacobian are poor. Forced are those that have a corner in a sector between
            two lines whose own angle is sharp, with a sine below S: no mesh can do better there. Flat are those that
            fill a sector of nearly 180 degrees alone, whose sine is below S as well: two faces could share it.
--aspect A  quads whose longest edge is more than A times their shortest are listed too
--shift     is added to the mesh's coordinates

Also the areas of faces, in percentiles: of all, and of those that touch no line. It shares no code with quarry. Needs
numpy and scipy.
"""
import argparse
import json
from collections import defaultdict

import numpy as np
from scipy.spatial import cKDTree

from msh_file import cross, read_lines, read_msh


def directions_at_nodes(lines):
    """-> nodes (n, 2), and for each the angles at which pieces leave it, ascending."""
    leaving = defaultdict(set)
    for chain in lines:
        for a, b in zip(map(tuple, chain.tolist()), map(tuple, chain[1:].tolist())):
            if a != b:
                leaving[a].add(float(np.arctan2(b[1] - a[1], b[0] - a[0])))
                leaving[b].add(float(np.arctan2(a[1] - b[1], a[0] - b[0])))
    return np.array(list(leaving)), [np.sort(list(angles)) for angles in leaving.values()]


def sector_degrees(angles, direction):
    """The angle between the two pieces at a node that enclose a direction; 360 at an end."""
    after = np.searchsorted(angles, direction) % len(angles)
    turn = (angles[after] - angles[after - 1]) % (2 * np.pi)
    return 360.0 if turn == 0 else float(np.degrees(turn))


def corner_figures(points, quads):
    """Sines (q, 4), edge lengths (q, 4) and the direction into the face at each corner (q, 4)."""
    p = points[quads]
    out = np.roll(p, -1, axis=1) - p
    length = np.hypot(out[..., 0], out[..., 1])
    back = -np.roll(out, 1, axis=1)
    sine = cross(out, back) / (length * np.roll(length, 1, axis=1))
    middle = out / length[..., None] + back / np.roll(length, 1, axis=1)[..., None]
    return sine, length, np.arctan2(middle[..., 1], middle[..., 0])


def areas(points, quads):
    p = points[quads]
    return 0.5 * cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])


def percentiles(area, touches):
    low, high = np.percentile(area, [1, 99])
    free = np.percentile(area[~touches], [1, 99])
    return {"p1": float(low), "p99": float(high), "ratio": float(high / low),
            "ratio_off_lines": float(free[1] / free[0]),
            "touching_pct": 100 * float(touches.mean()),
            "smallest_touching_pct": 100 * float(touches[area <= low].mean()),
            "largest_touching_pct": 100 * float(touches[area >= high].mean())}


class Mesh:
    def __init__(self, path, shift, near, lines):
        points, cells, _, self.quads = read_msh(path)
        self.points = points + np.array(shift)
        # Some tools turn the faces of whole surfaces round.
        self.turned = areas(self.points, self.quads) < 0
        self.quads[self.turned] = self.quads[self.turned][:, ::-1]
        self.sine, self.length, self.inward = corner_figures(self.points, self.quads)
        self.nodes, self.angles = directions_at_nodes(read_lines(lines))
        self.tree, self.near = cKDTree(self.nodes), near
        on_line = np.zeros(len(points), bool)
        on_line[cells.ravel()] = True
        self.touches = on_line[self.quads].any(axis=1)

    def sharpest_sector(self, face):
        """In degrees, over the corners of a face that are nodes of the lines; None if none is."""
        distance, node = self.tree.query(self.points[self.quads[face]])
        sectors = [sector_degrees(self.angles[node[k]], self.inward[face, k])
                   for k in range(4) if distance[k] <= self.near]
        return min(sectors, default=None)

    def describe(self, face):
        corner = int(self.sine[face].argmin())
        at = self.points[self.quads[face]]
        return {"at": at[corner].tolist(), "corners": at.tolist(), "sj": float(self.sine[face].min()),
                "aspect": float(self.length[face].max() / self.length[face].min()),
                "sector": self.sharpest_sector(face), "touches_line": bool(self.touches[face]),
                "to_node": float(self.tree.query(at)[0].min())}


def check(arguments):
    mesh = Mesh(arguments.mesh, arguments.shift, arguments.near, arguments.lines)
    shape, aspect = mesh.sine.min(axis=1), mesh.length.max(axis=1) / mesh.length.min(axis=1)
    sharp = np.degrees(np.arcsin(arguments.below))
    poor = [mesh.describe(face) for face in np.flatnonzero(shape < arguments.below)]
    forced = [face for face in poor if face["sector"] is not None and face["sector"] < sharp]
    flat = [face for face in poor if face["sector"] is not None and 180 - sharp < face["sector"] <= 180]
    others = [face for face in poor if face not in forced and face not in flat]
    slender = [mesh.describe(face) for face in np.flatnonzero(aspect > arguments.aspect)]
    return {"quads": len(mesh.quads), "poor": len(poor), "forced": len(forced), "flat": flat, "others": others,
            "inverted": int((shape <= 0).sum()), "turned": int(mesh.turned.sum()), "slender": slender,
            "areas": percentiles(areas(mesh.points, mesh.quads), mesh.touches)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("lines")
    parser.add_argument("--near", type=float, required=True)
    parser.add_argument("--below", type=float, default=0.2)
    parser.add_argument("--aspect", type=float, default=8)
    parser.add_argument("--shift", type=float, nargs=2, default=(0.0, 0.0))
    print(json.dumps(check(parser.parse_args()), indent=1))


if __name__ == "__main__":
    main()
