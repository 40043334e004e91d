#!/usr/bin/python3
"""Corners of faces on a surface that turn away from it: how many corner normals stand at more than 72 degrees to every
normal that the surface has within half of the face's longest edge of the corner. So creases are apart: a corner there
has the normals of both of their sides to choose from. Prints JSON.

usage: turned_corners.py MESH.obj REFERENCE.obj

Shares no code with quarry; numpy and scipy are all that it needs.
"""
import json
import sys

import numpy as np
from scipy.spatial import cKDTree

COSINE = np.cos(np.radians(72))
REACH = 0.5       # of the longest edge of the face
SPACING = 0.25    # of the median edge of the mesh: how near to one another samples of the surface lie at most
MOST = 32         # samples along a side of a triangle; larger ones are looked at one by one


def read_obj(path):
    """-> points (n, 3), faces as a list of lists."""
    points, faces = [], []
    with open(path) as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                points.append([float(word) for word in words[1:4]])
            elif words and words[0] == "f":
                faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return np.array(points), faces


def unit(vectors):
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.divide(vectors, length, out=np.zeros_like(vectors), where=length > 0)


def samples(corners, normals, rows):
    """Points of the triangles, by so many rows, and the normal of each one's triangle."""
    places, of = [], []
    for n in np.unique(rows):
        chosen = np.flatnonzero(rows == n)
        i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
        inside = (i + j <= n).ravel()
        u, v = i.ravel()[inside] / n, j.ravel()[inside] / n
        weights = np.stack([1 - u - v, u, v], axis=1)
        places.append(np.einsum("sk,tkd->tsd", weights, corners[chosen]).reshape(-1, 3))
        of.append(np.repeat(chosen, len(weights)))
    return np.concatenate(places), normals[np.concatenate(of)]


def distances(points, a, b, c):
    """Of points (n, 3) from a triangle."""
    def from_edge(p, q):
        along = np.clip((points - p) @ (q - p) / max((q - p) @ (q - p), 1e-300), 0, 1)
        return np.linalg.norm(points - p - along[:, None] * (q - p), axis=1)

    normal = np.cross(b - a, c - a)
    found = np.minimum(np.minimum(from_edge(a, b), from_edge(b, c)), from_edge(c, a))
    size = np.linalg.norm(normal)
    if size > 0:
        inside = np.all([np.cross(q - p, points - p) @ normal >= 0 for p, q in ((a, b), (b, c), (c, a))], axis=0)
        found[inside] = np.abs((points - a) @ normal / size)[inside]
    return found


def corners_of(points, faces):
    """-> place, normal and longest edge of its face, of each corner."""
    places, normals, reach = [], [], []
    for size in (3, 4):
        chosen = np.array([face for face in faces if len(face) == size])
        if not len(chosen):
            continue
        p = points[chosen]
        after, before = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
        places.append(p.reshape(-1, 3))
        normals.append(unit(np.cross(after, before)).reshape(-1, 3))
        reach.append(np.repeat(np.max(np.linalg.norm(after, axis=2), axis=1), size))
    return np.concatenate(places), np.concatenate(normals), np.concatenate(reach)


def main():
    points, faces = read_obj(sys.argv[1])
    reference, triangles = read_obj(sys.argv[2])
    places, normals, longest = corners_of(points, faces)
    spacing = SPACING * np.median(longest)
    surface = reference[np.array([t[:3] for t in triangles])]
    up = unit(np.cross(surface[:, 1] - surface[:, 0], surface[:, 2] - surface[:, 0]))
    sides = np.max(np.linalg.norm(surface - np.roll(surface, -1, axis=1), axis=2), axis=1)
    rows = np.maximum(np.ceil(sides / spacing), 1).astype(int)
    small, large = np.flatnonzero(rows <= MOST), np.flatnonzero(rows > MOST)
    sampled, sampled_up = samples(surface[small], up[small], rows[small])
    tree = cKDTree(sampled)
    # Most corners agree with what is nearest; of the others all within reach is looked at.
    doubtful = np.flatnonzero(np.einsum("ij,ij->i", normals, sampled_up[tree.query(places)[1]]) < COSINE)
    agrees = np.array([np.any(sampled_up[tree.query_ball_point(places[i], REACH * longest[i] + spacing)] @ normals[i]
                              >= COSINE) for i in doubtful], dtype=bool)
    for t in large:
        left = np.flatnonzero(~agrees)
        of = doubtful[left]
        facing = normals[of] @ up[t] >= COSINE
        agrees[left] = facing & (distances(places[of], *surface[t]) <= REACH * longest[of])
    turned = np.count_nonzero(~agrees)
    print(json.dumps({"corners": len(places), "beside_the_nearest": len(doubtful), "turned": int(turned)}))


if __name__ == "__main__":
    main()
