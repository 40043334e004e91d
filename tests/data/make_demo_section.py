#!/usr/bin/env python3
"""Draws demo_section.geojson: a geological cross-section of nobody's country, made up for the demo and the tests.

Folded beds under an unconformity, two normal faults that form a graben, a blind reverse fault whose throw dies out at
its tip, and fractures: most of them dangling, some in pairs that cross at a few degrees. Coordinates are metres
(easting along the section, elevation), rounded to centimetres. Most bed ends lie exactly on a vertex of the
fault that cuts them; every third one misses it by up to 20 cm, as hand-drawn sections do.

usage: make_demo_section.py > demo_section.geojson
"""

import json
import math
import random

LEFT, RIGHT, BOTTOM = 431200.0, 432200.0, -400.0
THICKNESS = (30, 52, 22, 46, 34, 27, 55, 24, 40)  # of the beds between the horizons, from the top
BEDS = len(THICKNESS) + 1
SEED = 20


def terrain(x):
    u = (x - LEFT) / 1000
    return 6 + 9 * math.sin(2.2 + 5.1 * u) + 4 * math.sin(17 * u)


def unconformity(x):
    u = (x - LEFT) / 1000
    return -31 + 7 * math.sin(1.1 + 4.0 * u) - 9 * u


def smooth_step(t):
    t = min(1.0, max(0.0, t))
    return t * t * (3 - 2 * t)


class Fault:
    """x as a function of elevation, and the throw: how far the beds on its right lie below those on its left."""

    def __init__(self, name, x_top, x_bottom, sag, top, throw, reach):
        self.name, self.top, self.throw, self.reach = name, top, throw, reach
        self.x_top, self.x_bottom, self.sag = x_top, x_bottom, sag
        self.ends = []  # where beds end on it

    def x(self, y):
        t = y / BOTTOM
        return self.x_top + (self.x_bottom - self.x_top) * t + self.sag * math.sin(math.pi * t)

    def shift(self, x, y, right):
        """Vertical displacement of a bed at (x, y) on one side."""
        strength = self.throw * (smooth_step((self.top - y) / 190) if self.reach else 1.0)
        fade = math.exp(-abs(x - self.x(y)) / self.reach) if self.reach else 1.0
        return (-0.5 if right else 0.5) * strength * fade


FAULTS = [
    Fault("F1", LEFT + 262, LEFT + 412, -14, 0.0, 25.0, 0.0),
    Fault("F2", LEFT + 648, LEFT + 521, 9, 0.0, -17.0, 0.0),
    Fault("F3", LEFT + 905, LEFT + 742, 12, -128.0, -34.0, 170.0),
]


def bed(number, x, side):
    """Elevation of a bed at x, in the block that lies right of those faults whose `side` is true."""
    u = (x - LEFT) / 1000
    depth = -42 - sum(THICKNESS[:number])
    fold = (22 - 0.8 * number) * math.sin(6.6 * u + 0.7 + 0.05 * number) + 3.5 * math.sin(15 * u + number)
    y = depth + fold + 30 * (0.45 - u)
    return y + sum(fault.shift(x, y, right) for fault, right in zip(FAULTS, side))


def right_of(fault, x, y):
    return x > fault.x(y)


def crossing(number, fault, side, low, high):
    """Where a bed of one block meets a fault, by bisection."""
    sign = right_of(fault, low, bed(number, low, side))
    for _ in range(60):
        middle = 0.5 * (low + high)
        if right_of(fault, middle, bed(number, middle, side)) == sign:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def rounded(x, y):
    return [round(x, 2), round(y, 2)]


def block_span(number, side, cutting):
    """The interval of x that a bed has between the faults that cut it."""
    low, high = LEFT, RIGHT
    ends = [None, None]
    for index in cutting:
        fault = FAULTS[index]
        x = crossing(number, fault, side, LEFT, RIGHT)
        if side[index] and x > low:
            low, ends[0] = x, fault
        elif not side[index] and x < high:
            high, ends[1] = x, fault
    return low, high, ends


def bed_pieces(number, chance):
    """The lines of one bed: broken at the faults, cut off at the unconformity and at the bottom."""
    tip = FAULTS[2]
    at_tip = bed(number, tip.x(tip.top), (True, True, True))
    blind = at_tip > tip.top - 12  # it passes above the tip unbroken
    cutting = (0, 1) if blind else (0, 1, 2)
    sides = [(False, False, False), (True, False, False), (True, True, False)]
    if not blind:
        sides.append((True, True, True))
    for side in sides:
        low, high, ends = block_span(number, side, cutting)
        points, here = [], low
        while here < high:
            points.append(here)
            here += chance.uniform(17, 31)
        if high - points[-1] < 9 and len(points) > 1:
            points.pop()
        points.append(high)

        def height(x):
            if not blind:
                return bed(number, x, side)
            return 0.5 * (bed(number, x, side[:2] + (False,)) + bed(number, x, side[:2] + (True,)))

        yield from clip([(x, height(x)) for x in points], ends, chance)


def clip(points, ends, chance):
    """Cuts a bed where it comes above the unconformity or below the bottom; the cut end lies just on that line."""
    def inside(p):
        return BOTTOM < p[1] < unconformity(p[0])

    def cut(a, b):
        low, high = 0.0, 1.0
        for _ in range(60):
            t = 0.5 * (low + high)
            p = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
            low, high = (t, high) if inside(p) else (low, t)
        p = (a[0] + low * (b[0] - a[0]), a[1] + low * (b[1] - a[1]))
        return (p[0], BOTTOM) if p[1] < BOTTOM + 1 else p

    run = []
    for index, point in enumerate(points):
        if inside(point):
            if not run and index > 0:
                run.append(cut(point, points[index - 1]))
            run.append(point)
        elif run:
            run.append(cut(run[-1], point))
            yield finish(run, (ends[0] if run[0] is points[0] else None, None), chance)
            run = []
    if len(run) > 1:
        yield finish(run, (ends[0] if run[0] is points[0] else None, ends[1]), chance)


def finish(run, ends, chance):
    """Rounds a bed; an end on a fault becomes a vertex of the fault, or misses it by a little."""
    line = [rounded(*p) for p in run]
    for fault, at in ((ends[0], 0), (ends[1], -1)):
        if fault is None:
            continue
        if chance.random() < 1 / 3:
            line[at][0] = round(line[at][0] + chance.uniform(-0.2, 0.2), 2)
        else:
            fault.ends.append(line[at])
    return line


def fault_line(fault):
    """Its own points every 25 m, and the ends of the beds. From the unconformity (or its tip) to the bottom."""
    if fault.reach:
        start = [fault.x(fault.top), fault.top]
    else:
        y = 0.0
        for _ in range(40):
            y = unconformity(fault.x(y))
        start = [fault.x(y), y]
    points = [rounded(*start)] + list(fault.ends)
    y = start[1] - 25
    while y > BOTTOM + 10:
        if all(abs(y - p[1]) > 8 for p in points):
            points.append(rounded(fault.x(y), y))
        y -= 25
    points.append([round(fault.x(BOTTOM), 2), BOTTOM])
    return sorted(points, key=lambda p: -p[1])


def outline():
    steps = 40
    across = [RIGHT - (RIGHT - LEFT) * i / steps for i in range(steps + 1)]
    top = [rounded(x, terrain(x)) for x in across]
    ring = [[LEFT, BOTTOM], [RIGHT, BOTTOM]] + top
    return ring + [ring[0]]


def allowed(line):
    return all(LEFT + 8 < x < RIGHT - 8 and BOTTOM + 8 < y < unconformity(x) - 4 for x, y in line)


def segment(x, y, length, degrees, bend=0.0):
    a = math.radians(degrees)
    dx, dy = 0.5 * length * math.cos(a), 0.5 * length * math.sin(a)
    middle = rounded(x - bend * dy, y + bend * dx)
    return [rounded(x - dx, y - dy)] + ([middle] if bend else []) + [rounded(x + dx, y + dy)]


def fractures(chance):
    """Steep joints everywhere, others along the faults, and pairs that cross at 1.5 to 4.5 degrees."""
    lines = []
    while len(lines) < 40:  # background joints
        line = segment(chance.uniform(LEFT, RIGHT), chance.uniform(BOTTOM, -40), chance.uniform(16, 46),
                       chance.gauss(84, 7), chance.uniform(-0.06, 0.06))
        if allowed(line):
            lines.append(line)
    while len(lines) < 74:  # damage zones, along the faults
        fault = chance.choice(FAULTS)
        y = chance.uniform(BOTTOM + 20, min(-50.0, fault.top + 10))
        slope = math.degrees(math.atan2(10, fault.x(y + 5) - fault.x(y - 5)))
        x, length = fault.x(y) + chance.gauss(0, 26), chance.uniform(12, 40)
        line = segment(x, y, length, slope + chance.choice((-1, 1)) * chance.uniform(8, 35))
        if allowed(line):
            lines.append(line)
    while len(lines) < 74 + 14:  # pairs
        x, y = chance.uniform(LEFT, RIGHT), chance.uniform(BOTTOM, -60)
        angle = chance.choice((chance.gauss(62, 5), chance.gauss(115, 5)))
        length = chance.uniform(48, 80)
        second = segment(x + 0.3, y + 1.1, length * chance.uniform(0.7, 1.1), angle + chance.uniform(1.5, 4.5))
        pair = [segment(x, y, length, angle), second]
        if all(allowed(line) for line in pair):
            lines.extend(pair)
    return lines


def feature(kind, name, geometry_type, coordinates):
    return {"type": "Feature", "properties": {"kind": kind, "name": name},
            "geometry": {"type": geometry_type, "coordinates": coordinates}}


def main():
    chance = random.Random(SEED)
    features = [feature("outline", "section", "Polygon", [outline()])]
    beds = []
    for number in range(BEDS):
        beds += [feature("horizon", f"B{number + 1}", "LineString", line) for line in bed_pieces(number, chance)]
    across = [LEFT + 25 * i for i in range(41)]
    tops = [fault_line(fault)[0] for fault in FAULTS[:2]]
    surface = sorted([rounded(x, unconformity(x)) for x in across if all(abs(x - p[0]) > 6 for p in tops)] + tops)
    features.append(feature("unconformity", "U", "LineString", surface))
    features += [feature("fault", fault.name, "LineString", fault_line(fault)) for fault in FAULTS]
    features += beds
    features += [feature("fracture", f"J{i + 1}", "LineString", line) for i, line in enumerate(fractures(chance))]
    rows = ",\n".join(json.dumps(f, separators=(",", ":")) for f in features)
    print('{"type":"FeatureCollection","name":"demo_section","features":[\n' + rows + "\n]}")


if __name__ == "__main__":
    main()
