"""Reads a .msh 4.1 in ASCII and noded lines in GeoJSON into numpy arrays: what the checks beside it stand on.

They share no code with quarry. numpy and scipy are all they need.
"""
import json

import numpy as np

NODES_OF = {1: 2, 2: 3, 3: 4, 15: 1}  # gmsh's element types


def section(raw, name):
    begin = raw.index(b"$" + name) + len(name) + 1
    return np.array(raw[begin:raw.index(b"$End" + name, begin)].split(), dtype=float)


def read_nodes(numbers):
    ids, points, at = [], [], 4
    for _ in range(int(numbers[0])):
        dimension, parametric, count = int(numbers[at]), int(numbers[at + 2]), int(numbers[at + 3])
        width = 3 + (dimension if parametric else 0)
        at += 4
        ids.append(numbers[at:at + count].astype(np.int64))
        at += count
        points.append(numbers[at:at + count * width].reshape(count, width)[:, :2])
        at += count * width
    return np.concatenate(ids), np.concatenate(points)


def read_msh(path):
    """-> points (n, 2), lines (l, 2), triangles (t, 3), quads (q, 4), as indices of points."""
    with open(path, "rb") as file:
        raw = file.read()
    if not raw.split(b"\n", 2)[1].startswith(b"4.1 0 "):
        raise ValueError(f"{path}: not a .msh 4.1 in ASCII")
    ids, points = read_nodes(section(raw, b"Nodes"))
    numbers, cells, at = section(raw, b"Elements"), {1: [], 2: [], 3: []}, 4
    index = np.full(ids.max() + 1, -1, np.int64)
    index[ids] = np.arange(len(ids))
    for _ in range(int(numbers[0])):
        kind, count = int(numbers[at + 2]), int(numbers[at + 3])
        width = 1 + NODES_OF[kind]
        at += 4
        if kind in cells:
            cells[kind].append(index[numbers[at:at + count * width].reshape(count, width)[:, 1:].astype(np.int64)])
        at += count * width
    return (points, *(np.concatenate(cells[kind]) if cells[kind] else np.zeros((0, NODES_OF[kind]), np.int64)
                      for kind in (1, 2, 3)))


def edges_of(*cells):
    """The edges of faces, each once, as (m, 2) with the smaller index first."""
    every = [np.column_stack((c[:, i], np.roll(c, -1, axis=1)[:, i])) for c in cells for i in range(c.shape[1])]
    return np.unique(np.sort(np.concatenate(every), axis=1), axis=0)


def read_lines(path):
    """The lines of a GeoJSON of LineStrings: for each an array (k, 2)."""
    with open(path) as file:
        features = json.load(file)["features"]
    return [np.array(f["geometry"]["coordinates"], float)[:, :2] for f in features]


def cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
