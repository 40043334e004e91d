#!/usr/bin/env python3
"""Meshes the section that ships with the repository into every format, and looks whether the readers of others find the
same points, faces, lines and groups in it: meshio and h5py; Gmsh and VTK too, where they are installed.

usage: mesh_in_readers.py QUARRY       prints a line for each reader and format, exits with 1 if any finds something else
"""

import json
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import h5py
import meshio

SECTION = Path(__file__).resolve().parent.parent / "data" / "demo_section.geojson"
NAMES = {"line": "lines", "line3": "lines", "triangle": "triangles", "triangle6": "triangles", "quad": "quads",
         "quad8": "quads", "quad9": "quads"}
VTK_NAMES = {3: "lines", 21: "lines", 5: "triangles", 22: "triangles", 9: "quads", 23: "quads", 28: "quads"}


def with_meshio(path):
    mesh = meshio.read(path)
    found = Counter(points=len(mesh.points))
    for block in mesh.cells:
        found[NAMES[block.type]] += len(block.data)
    sets = set(mesh.cell_sets) | set(mesh.field_data)
    found["regions"] = sum(name.startswith("region_") for name in sets)
    found["line groups"] = len({name for name in sets | set(mesh.point_sets) if name.startswith("line_")})
    return found


def with_meshio_as_shells(path):
    """It knows elements of second order as shells alone."""
    shells = path.with_name("shells.inp")
    shells.write_text(path.read_text().replace("TYPE=CPS8", "TYPE=S8R").replace("TYPE=CPS6", "TYPE=STRI65"))
    return with_meshio(shells)


def with_meshio_without_values(path):
    """Its reader of AVS files stumbles over values of cells of several types, which it writes itself."""
    lines = path.read_text().splitlines()
    first = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    points, cells = (int(word) for word in lines[first].split()[:2])
    plain = path.with_name("plain.avs")
    plain.write_text("\n".join([f"{points} {cells} 0 0 0"] + lines[first + 1:first + 1 + points + cells]) + "\n")
    return with_meshio(plain)


def with_h5py(path):
    with h5py.File(path) as file:
        grid = file["VTKHDF"]
        assert grid.attrs["Type"] == b"UnstructuredGrid" and list(grid.attrs["Version"]) == [1, 0]
        found = Counter(VTK_NAMES[kind] for kind in grid["Types"][:])
        found["points"] = len(grid["Points"])
        found["regions"] = len(set(grid["CellData"]["region"][:]) - {-1})
        return found


def with_gmsh(path):
    """Gmsh writes again what it has read."""
    again = path.with_name("again.msh")
    subprocess.run(["gmsh", path, "-0", "-format", "msh41", "-o", again], check=True, capture_output=True)
    kinds = {1: "lines", 8: "lines", 2: "triangles", 9: "triangles", 3: "quads", 16: "quads", 10: "quads"}
    lines, found = iter(again.read_text().splitlines()), Counter()
    for line in lines:
        if line == "$PhysicalNames":
            names = [next(lines).split(maxsplit=2)[2].strip('"') for _ in range(int(next(lines)))]
            found["regions"] = sum(name.startswith("region_") for name in names)
            found["line groups"] = sum(name.startswith("line_") for name in names)
        elif line == "$Nodes":
            found["points"] = int(next(lines).split()[1])
        elif line == "$Elements":
            for _ in range(int(next(lines).split()[0])):
                kind, count = (int(word) for word in next(lines).split()[2:])
                found[kinds[kind]] += count
                for _ in range(count):
                    next(lines)
    return found


def with_vtk(path):
    import vtk  # pylint: disable=import-outside-toplevel
    reader = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".vtkhdf": vtk.vtkHDFReader, ".avs": vtk.vtkAVSucdReader}[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    found = Counter(VTK_NAMES[grid.GetCellType(i)] for i in range(grid.GetNumberOfCells()))
    regions = grid.GetCellData().GetArray("region")
    found["points"] = grid.GetNumberOfPoints()
    found["regions"] = len({regions.GetTuple1(i) for i in range(regions.GetNumberOfTuples())} - {-1})
    return found


def readers():
    """Triples of extension, name of the reader and reader."""
    yield from [(".msh", "meshio", with_meshio), (".inp", "meshio", with_meshio_as_shells),
                (".avs", "meshio", with_meshio_without_values)]
    if shutil.which("gmsh"):
        yield ".msh", "gmsh", with_gmsh
    else:
        print("mesh_in_readers: there is no gmsh")
    try:
        __import__("vtk")
        yield from [(extension, "vtk", with_vtk) for extension in (".vtu", ".vtkhdf", ".avs")]
    except ImportError:
        print("mesh_in_readers: there is no vtk")


SECOND_ORDER = {"2": [".vtu", ".vtkhdf", ".msh", ".inp"], "2-full": [".vtu", ".vtkhdf", ".msh"]}
VARIANTS = [[], ["--elements", "mixed", "--mixed-quality", "0.6"], ["--order", "2"], ["--order", "2-full"],
            ["--split-fractures"], ["--split-fractures", "--order", "2"]]


def mesh(folder, extension, options):
    """The mesh file, and what its report counts."""
    path, report = folder / f"section{extension}", folder / "report.json"
    subprocess.run([sys.argv[1], "mesh", SECTION, "-o", path, "--report", report, "--size", "12", "--quiet"] + options,
                   check=True)
    told = json.loads(report.read_text())["counts"]
    return path, {"points": told["vertices"], "quads": told["quads"], "triangles": told["triangles"],
                  "lines": told["line_edges"], "regions": told["regions"]}


def for_others(folder):
    """What is wrong with the files for OpenGeoSys and MOOSE, in the eyes of meshio."""
    wrong = []
    ogs = meshio.read(mesh(folder, ".vtu", ["--for", "ogs"])[0])
    materials = {block.type: set(ids.ravel()) for block, ids in zip(ogs.cells, ogs.cell_data["MaterialIDs"])}
    if materials["quad"] != set(range(len(materials["quad"]))) or min(materials["line"]) != len(materials["quad"]):
        wrong.append(f"MaterialIDs {materials}")
    moose = meshio.read(mesh(folder, ".msh", ["--for", "moose"])[0])
    tags = [int(tag) for tag, _ in moose.field_data.values()]
    if len(set(tags)) != len(tags):
        wrong.append("a tag is there twice")
    lines = Counter()
    blocks = {int(tag) for name, (tag, _) in moose.field_data.items() if name.endswith("_lower_dimensional_block")}
    for block, ids in zip(moose.cells, moose.cell_data["gmsh:physical"]):
        if block.type == "line" and int(ids.ravel()[0]) in blocks:
            lines["moose"] += len(block.data)
    lines["ogs"] = sum(len(block.data) for block in ogs.cells if block.type == "line")
    print(f"mesh_in_readers: line elements of fractures: {dict(lines)}")
    if lines["moose"] != lines["ogs"] or not lines["ogs"]:
        wrong.append("other line elements for one than for the other")
    return wrong


def differences(found, wanted, missing=()):
    return {key: (found[key], value) for key, value in wanted.items() if key not in missing and found[key] != value}


def main():
    failures = 0

    def judge(name, extension, options, found, wrong):
        nonlocal failures
        print(f"mesh_in_readers: {name} reads {extension} {' '.join(options)}: {dict(found)}")
        if wrong:
            print(f"FAILED: found and wanted {wrong}")
            failures += 1

    with tempfile.TemporaryDirectory() as name_of_folder:
        folder = Path(name_of_folder)
        for wrong in for_others(folder):
            print(f"FAILED: {wrong}")
            failures += 1
        for options in VARIANTS:
            order = options[options.index("--order") + 1] if "--order" in options else "1"
            path, told = mesh(folder, ".vtkhdf", options)
            wanted = with_h5py(path)
            # The report counts corners, and what there is before it is split.
            uncounted = ["points"] if order != "1" else []
            uncounted += ["points", "lines"] if "--split-fractures" in options else []
            judge("h5py", ".vtkhdf", options, wanted, differences(wanted, told, uncounted))
            for extension, name, read in readers():
                if order != "1" and extension not in SECOND_ORDER[order]:
                    continue
                found = read(mesh(folder, extension, options)[0])
                # Lines are surfaces of a .inp, which meshio passes over, and sets of nodes; .avs files have no names.
                missing = {".inp": ["lines"], ".avs": [] if name == "vtk" else ["regions"]}.get(extension, [])
                wrong = differences(found, wanted, missing)
                if extension in (".msh", ".inp") and not found["line groups"]:
                    wrong["line groups"] = (0, "some")
                judge(name, extension, options, found, wrong)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
