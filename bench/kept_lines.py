#!/usr/bin/python3
"""Says how much of each line is covered by edges of a mesh, as JSON.

  kept_lines.py MESH.msh LINES.geojson|LINES.msh --near D [--cells] [--shift X Y]

LINES       lines of a GeoJSON, or the line elements of another mesh, each a line of its own
--near D    an edge covers the stretch of a piece beside which it lies, if both of its ends are within D of the straight
            line through the piece
--cells     only the mesh's line elements count, in place of all edges of its faces
--shift     is added to the mesh's coordinates

An independent check: it shares no code with quarry. Needs numpy and scipy.
"""
import argparse
import json
from collections import defaultdict

import numpy as np
from scipy.spatial import cKDTree

from msh_file import cross, edges_of, read_lines, read_msh


def pieces_of(path):
    """-> starts, ends (both (p, 2)) and the line of each straight piece."""
    if path.endswith(".msh"):
        points, cells, _, _ = read_msh(path)
        return points[cells[:, 0]], points[cells[:, 1]], np.arange(len(cells))
    lines = read_lines(path)
    start, end = np.concatenate([c[:-1] for c in lines]), np.concatenate([c[1:] for c in lines])
    return start, end, np.concatenate([np.full(len(c) - 1, i) for i, c in enumerate(lines)])


def pairs_nearby(points, edges, start, end, near):
    """-> (piece, edge) of all that come within `near` of each other, and more."""
    length, reach = np.hypot(*(end - start).T), np.hypot(*(points[edges[:, 1]] - points[edges[:, 0]]).T).max() / 2
    step = max(np.median(length) / 2, length.max() / 2000)
    count = np.maximum(1, np.ceil(length / step)).astype(np.int64)
    owner = np.repeat(np.arange(len(start)), count)
    at = (np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count) + 0.5) / count[owner]
    samples = start[owner] + at[:, None] * (end - start)[owner]
    close = cKDTree(points[edges].mean(axis=1)).query_ball_point(samples, reach + step / 2 + near)
    piece = np.repeat(owner, [len(each) for each in close])
    edge = np.concatenate([np.array(each, np.int64) for each in close])
    both = np.unique(piece * len(edges) + edge)
    return both // len(edges), both % len(edges)


def union_length(intervals):
    total, reached = 0.0, -np.inf
    for a, b in sorted(intervals):
        total += max(0.0, b - max(a, reached))
        reached = max(reached, b)
    return total


def covered_lengths(points, edges, start, end, near):
    """-> length of each piece, and how much of it is covered."""
    length = np.hypot(*(end - start).T)
    along = (end - start) / length[:, None]
    piece, edge = pairs_nearby(points, edges, start, end, near)
    ends = points[edges[edge]] - start[piece][:, None]
    off = np.abs(cross(along[piece][:, None], ends)).max(axis=1)
    at = np.sort((ends * along[piece][:, None]).sum(axis=-1), axis=1)
    at = np.clip(at, 0, length[piece][:, None])
    on = (off <= near) & (at[:, 1] > at[:, 0])
    intervals = defaultdict(list)
    for p, (a, b) in zip(piece[on].tolist(), at[on].tolist()):
        intervals[p].append((a, b))
    return length, np.array([union_length(intervals[p]) for p in range(len(length))])


def check(mesh, lines, near, cells, shift):
    points, line_cells, triangles, quads = read_msh(mesh)
    start, end, line = pieces_of(lines)
    edges = line_cells if cells else edges_of(triangles, quads)
    length, covered = covered_lengths(points + np.array(shift), edges, start, end, near)
    whole, kept = np.bincount(line, length), np.bincount(line, covered)
    missing = np.maximum(0.0, whole - kept)
    # Both ends of an uncovered stretch may be off by the distance that counts as on the line.
    lost = np.flatnonzero(missing > 4 * near + 1e-9 * whole)
    worst = lost[np.argsort(-missing[lost], kind="stable")][:10]
    return {"lines": len(whole), "length": float(whole.sum()), "covered_pct": 100 * float(kept.sum() / whole.sum()),
            "missing_length": float(missing[lost].sum()), "lines_not_whole": len(lost),
            "worst": [{"line": int(i), "length": float(whole[i]), "covered_pct": 100 * float(kept[i] / whole[i]),
                       "at": start[line == i][0].tolist()} for i in worst]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("lines")
    parser.add_argument("--near", type=float, required=True)
    parser.add_argument("--cells", action="store_true")
    parser.add_argument("--shift", type=float, nargs=2, default=(0.0, 0.0))
    a = parser.parse_args()
    print(json.dumps(check(a.mesh, a.lines, a.near, a.cells, a.shift), indent=1))


if __name__ == "__main__":
    main()
