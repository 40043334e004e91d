#!/usr/bin/env python3
"""Draws a geological horizon and the fractures on it, made up for the tests and the picture of the README: a folded
surface that ends at the two sides of a fault, as triangles, and traces on a map of it.

usage: make_demo_horizon.py surface > demo_horizon.obj
       make_demo_horizon.py traces > demo_horizon_traces.geojson
"""

import json
import math
import random
import sys

COLUMNS, ROWS = 44, 30  # of cells on each side of the fault
WIDTH, DEPTH = 1200.0, 800.0  # metres
WEST, SOUTH = 431000.0, 5712000.0
SEED = 7


def fault(y):
    """Where the fault crosses the map, from west to east."""
    return 0.47 * WIDTH + 70 * math.sin(2.4 * y / DEPTH) + 0.1 * y


def throw(y):
    """How far the eastern side lies below the western one: nothing at the southern end."""
    return 85 * math.sin(0.5 * math.pi * y / DEPTH)


def height(x, y, side):
    u, v = x / WIDTH, y / DEPTH
    folds = 75 * math.sin(4.3 * u + 1.2 * v) + 30 * math.cos(5.2 * v - 2.1 * u) + 14 * math.sin(13 * u - 4 * v)
    drag = math.exp(-abs(x - fault(y)) / 60)
    return folds - 900 - side * throw(y) * (1 - 0.5 * drag) - (1 - side) * 0.35 * throw(y) * drag


def point_of(side, i, j):
    y = DEPTH * j / ROWS
    middle = fault(y)
    share = i / COLUMNS
    x = middle * share if side == 0 else middle + (WIDTH - middle) * share
    return x, y, height(x, y, side)


def surface():
    print("# a made-up horizon, cut by a fault; metres")
    for side in (0, 1):
        for j in range(ROWS + 1):
            for i in range(COLUMNS + 1):
                x, y, z = point_of(side, i, j)
                print(f"v {WEST + x:.2f} {SOUTH + y:.2f} {z:.2f}")
    for side in (0, 1):
        print("g", ("west", "east")[side])
        base = side * (COLUMNS + 1) * (ROWS + 1) + 1
        for j in range(ROWS):
            for i in range(COLUMNS):
                a = base + j * (COLUMNS + 1) + i
                b, c, d = a + 1, a + COLUMNS + 2, a + COLUMNS + 1
                for corners in ((a, b, c), (a, c, d)) if (i + j) % 2 else ((a, b, d), (b, c, d)):
                    print("f", *corners)


def traces():
    draw = random.Random(SEED)
    lines = []
    for strike, count in ((0.5, 16), (2.0, 12)):
        for _ in range(count):
            length = 60 * (1 - draw.random()) ** -0.45
            angle = draw.gauss(strike, 0.12)
            x, y = WIDTH * draw.random(), DEPTH * draw.random()
            bend = draw.gauss(0, 0.12)
            half = (length * math.cos(angle) / 2, length * math.sin(angle) / 2)
            middle = (x - bend * half[1], y + bend * half[0])
            course = [(x - half[0], y - half[1]), middle, (x + half[0], y + half[1])]
            lines.append([[round(WEST + p, 2), round(SOUTH + q, 2)] for p, q in course])
    features = [{"type": "Feature", "properties": {"name": f"fracture {i + 1}"},
                 "geometry": {"type": "LineString", "coordinates": line}} for i, line in enumerate(lines)]
    json.dump({"type": "FeatureCollection", "features": features}, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    {"surface": surface, "traces": traces}[sys.argv[1]]()
