#!/usr/bin/python3
"""netgen on the lines that `quarry clean` wrote: one job of its own, file to file. Debian's python3-netgen.

  netgen_peer.py CLEAN.geojson OUT.vol --size H [--quads]
  netgen_peer.py OUT.vol OUT.msh                            its file as a .msh 2.2

All within the outline is one domain, and every other line a part of its geometry, dead ends too. --quads: dominated by
quadrilaterals, which is as near as it comes to quads alone. Prints how many quadrilaterals and triangles there are.
"""
import argparse
import json

import gmsh_geo


def outline_sides(points, edges, outline):
    """(from, to) of each outline edge, the inside on its left."""
    for loop in gmsh_geo.trace_loops(points, edges, outline):
        if gmsh_geo.signed_area(gmsh_geo.corners(points, edges, loop)) > 0:
            for k in loop:
                a, b = edges[abs(k) - 1]
                yield (a, b) if k > 0 else (b, a)


def geometry(path):
    from netgen.geom2d import SplineGeometry
    points, edges, outline = gmsh_geo.read_graph(path)
    lines = SplineGeometry()
    numbers = [lines.AddPoint(*point) for point in points]
    for a, b in outline_sides(points, edges, outline):
        lines.Append(["line", numbers[a], numbers[b]], leftdomain=1, rightdomain=0, bc=1)
    for (a, b), outer in zip(edges, outline):
        if not outer:
            lines.Append(["line", numbers[a], numbers[b]], leftdomain=1, rightdomain=1, bc=2)
    return lines


def export(source, target):
    from netgen.meshing import Mesh
    mesh = Mesh()
    mesh.Load(source)
    mesh.Export(target, "Gmsh2 Format")
    with open(target) as file:
        text = file.read()
    # What it writes differs from 2.2 in the number alone.
    with open(target, "w") as file:
        file.write(text.replace("2.000000 0 8", "2.2 0 8", 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("target")
    parser.add_argument("--size", type=float)
    parser.add_argument("--quads", action="store_true")
    arguments = parser.parse_args()
    if arguments.source.endswith(".vol"):
        export(arguments.source, arguments.target)
        return
    if arguments.size is None:
        parser.error("--size: how long edges are to be")
    mesh = geometry(arguments.source).GenerateMesh(maxh=arguments.size, quad_dominated=arguments.quads)
    mesh.Save(arguments.target)
    corners = [len(element.vertices) for element in mesh.Elements2D()]
    # Its library prints to stdout as it goes: this is the last line.
    print("\n" + json.dumps({"quads": corners.count(4), "triangles": corners.count(3)}))


if __name__ == "__main__":
    main()
