#!/usr/bin/python3
"""`quarry improve` on meshes in space: gmsh's own quads of CAD shapes, in all its recombinations, and halved clusters of
scans. Writes docs/results-improve.md. From the root of the repository:

  bench/improve_surfaces.py [--quick] [--data DIR] [--referee DIR] [--quarry build/quarry] [--out FILE]

--quick     one shape in one way, the table to stdout: to see that everything works
--data      folder with surface/*.obj; without it the scans are left out
--referee   folder with surface.py, an independent checker; without it that column stays empty

The shapes are drawn by gmsh's OpenCASCADE; every curve and every face of them is a physical group, so that all edges
between faces are tagged.
"""
import argparse
import os
import tempfile

from jobs import Referee, load_json, machine_text, run, say, source_commit
from quads_map_tables import IMPROVED, improved_cells
from tables import failed_row, table, thousands

# OpenCASCADE's shape, and the wanted edge.
SHAPES = {
    "bracket": ("""Box(1) = {0, 0, 0, 4, 3, 1};
Cylinder(2) = {1.2, 1.5, -1, 0, 0, 3, 0.6};
Cylinder(3) = {3, 1.5, 0.5, 0, 0, 2, 0.5};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanUnion(5) = { Volume{4}; Delete; }{ Volume{3}; Delete; };""", 0.08),
    "pipes": ("""Cylinder(1) = {-2, 0, 0, 4, 0, 0, 0.8};
Cylinder(2) = {0, 0, 0, 0.5, 0.4, 2, 0.5};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };""", 0.06),
    "torus": ("Torus(1) = {0, 0, 0, 1.5, 0.5};", 0.06),
    "ball": ("Sphere(1) = {0, 0, 0, 1};", 0.05),
}
GROUPS = """
curves() = Curve{:};
For i In {0:#curves()-1}
  Physical Curve(i+1) = {curves(i)};
EndFor
faces() = Surface{:};
For i In {0:#faces()-1}
  Physical Surface(i+1) = {faces(i)};
EndFor
"""
RECOMBINATIONS = ("simple", "blossom", "simple full quad", "blossom full quad")
SCANS = ("hammer_scan", "fandisk", "spot")
SCAN_QUADS = 10000

PAGE = """# `quarry improve` in space

Made by `bench/improve_surfaces.py`, which anyone can rerun; do not edit. Quads of gmsh {gmsh} on shapes of its
OpenCASCADE (`-algo front2d`, each of its recombinations), every curve tagged; and scans that are not part of this
repository, meshed by `quarry mesh --count {scan_quads} --quads cluster --cleanup none`. Before -> after; ok where it is no worse.
The mesh before is the surface after: the referee looks at validity, at which side is up, at topology, and
at the distance both ways, of which the largest is told as a share of the diagonal. That all tagged edges have the length that
they had is checked at the end of every job. Seconds of processor time, one thread, file to file.

Machine: {machine}; sources as of {commit}.

{table}
{text}"""
TEXT_HEADING = "## What the figures say"


def gmsh_mesh(folder, name, kind):
    shape, size = SHAPES[name]
    geo, mesh = os.path.join(folder, name + ".geo"), os.path.join(folder, f"{name}_{kind}.msh")
    with open(geo, "w") as file:
        file.write(f'SetFactory("OpenCASCADE");\n{shape}\n{GROUPS}Mesh.MeshSizeMax = {size};\n')
    settings = {"Mesh.Algorithm": 6, "Mesh.RecombineAll": 1, "Mesh.RecombinationAlgorithm": kind}
    options = [word for pair in settings.items() for word in ("-setnumber", *pair)]
    run(["gmsh", "-2", geo, "-format", "msh41", *options, "-o", mesh], folder, 300)
    # gmsh ends with 1 after single faces that it could not mesh in this way; what it wrote is what there is.
    return mesh if os.path.exists(mesh) else None


def scan_mesh(arguments, folder, name):
    surface = os.path.join(arguments.data, "surface", name + ".obj")
    mesh = os.path.join(folder, name + ".vtu")
    if not os.path.exists(surface):
        return None
    done = run([arguments.quarry, "mesh", surface, "--count", SCAN_QUADS, "--quads", "cluster", "--cleanup", "none", "-o",
                mesh, "--quiet"], folder)
    return mesh if done.code == 0 else None


def measure(arguments, referee, folder, before, label):
    after, report = before + ".after.vtu", before + ".json"
    done = run([arguments.quarry, "improve", before, "-o", after, "--report", report, "--threads", "1", "--quiet"], folder)
    say(f"{' '.join(label)}: {done.wall:.1f} s" + ("" if done.code == 0 else f", {done.why}"))
    if done.code != 0:
        return {"label": label, "error": done.why}
    job = load_json(report)
    row = {"label": label, "before": job["quality_before"], "after": job["quality"], "counts": job["counts"],
           "seconds": done.cpu}
    if referee.there:
        surface = before + ".obj"
        run([arguments.quarry, "convert", before, surface, "--quiet"], folder)
        row["referee"] = referee.call("surface.py", after, "--ref", surface)
    return row


def checked(row):
    found = row.get("referee")
    if found is None:
        return ""
    if found["failed"]:
        return "**" + "; ".join(found["failed"]) + "**"
    return f"ok, {found['hausdorff']:.2g}"


def make_table(rows):
    header = ["mesh", "how", "quads", "triangles", *[name for name, *_ in IMPROVED], "tagged edges", "referee, distance", "s"]
    body = []
    for row in rows:
        if "error" in row:
            body.append(failed_row(row, row["label"], len(header)))
            continue
        before, after = row["before"], row["after"]
        body.append([*row["label"], *[f"{thousands(before[kind])} -> {thousands(after[kind])}"
                                      for kind in ("quads", "triangles")],
                     *improved_cells(before, after), thousands(row["counts"]["tagged_edges"]), checked(row), f"{row['seconds']:.1f}"])
    return table(header, body)


def text_of(path):
    """What stands below the table by hand."""
    if not os.path.exists(path):
        return ""
    with open(path) as file:
        page = file.read()
    return "\n" + page[page.index(TEXT_HEADING):] if TEXT_HEADING in page else ""


def gmsh_version(folder):
    printed = os.path.join(folder, "version.txt")
    run(["/bin/sh", "-c", f"gmsh --version > '{printed}' 2>&1"], folder)
    with open(printed) as file:
        return file.read().strip()


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--data", default="../shared/data")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--out", default="docs/results-improve.md")
    arguments = parser.parse_args()
    arguments.quarry = os.path.abspath(arguments.quarry)
    return arguments


def main():
    arguments = parse()
    referee = Referee(arguments.referee)
    with tempfile.TemporaryDirectory() as folder:
        rows = []
        for name in list(SHAPES)[:1] if arguments.quick else SHAPES:
            for kind, way in list(enumerate(RECOMBINATIONS))[:1] if arguments.quick else enumerate(RECOMBINATIONS):
                mesh = gmsh_mesh(folder, name, kind)
                label = [name, f"gmsh, {way}"]
                rows.append(measure(arguments, referee, folder, mesh, label) if mesh else
                            {"label": label, "error": "gmsh wrote no mesh"})
        for name in () if arguments.quick else SCANS:
            mesh = scan_mesh(arguments, folder, name)
            if mesh:
                rows.append(measure(arguments, referee, folder, mesh, [name, "clusters"]))
        if arguments.quick:
            print(make_table(rows))
            return
        page = PAGE.format(gmsh=gmsh_version(folder), scan_quads=SCAN_QUADS, machine=machine_text(), commit=source_commit(),
                           table=make_table(rows), text=text_of(arguments.out))
    with open(arguments.out, "w") as file:
        file.write(page)
    say(f"wrote {arguments.out}")
    raise SystemExit(1 if any("error" in row or row.get("referee", {}).get("failed") for row in rows) else 0)


if __name__ == "__main__":
    main()
