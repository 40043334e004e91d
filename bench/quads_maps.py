"""Sections of bench/quads.py on whole jobs: maps and a network beside gmsh, `quarry improve`, and threads."""
import shutil

import gmsh_geo
from gmsh_peer import GMSH_WAYS, gmsh_command, mesh_at_count
from jobs import digest, median_run, run, say
from maps import box_of

MAPS = ("kb11_traces", "hastholmen_traces", "souter_all", "lineaments_200k")
COUNTS = (25000, 60000, 125000)
THREADS = (1, 2, 4, 7)
DEMO = "tests/data/demo_section.geojson"
DEMO_SIZE = 6
# gmsh's ways on all lines that pair triangles, and leave none.
PAIRING = [way for way in GMSH_WAYS if way[1] == "faces" and "RecombineAll" in way[3]]
RECOMBINATIONS = ("simple", "blossom", "simple full quad", "blossom full quad")


def beside_gmsh(jobs, label, lines, report, mesh, extra=()):
    """What the checks say of a mesh and of gmsh's at the same count on the same cleaned lines."""
    size, clean = report["options"]["size"], jobs.path("clean.geojson")
    jobs.clean(lines, clean, size, extra)
    quads = report["counts"]["quads"]
    row = {"label": label, "size": size, "counts": report["counts"], "quality": report["quality"],
           "cleanup": report["cleanup"], "times": report["times"], "agreement": jobs.agreement(mesh, report["quality"]),
           **jobs.against_lines(mesh, clean, size), "gmsh": []}
    plain = jobs.path("plain.msh")
    done, before = jobs.mesh(lines, plain, size, [*extra, "--cleanup", "none"])
    if before:
        row["without"] = {"quality": before["quality"], **jobs.against_lines(plain, clean, size)}
    for way in PAIRING if shutil.which("gmsh") else ():
        peer = mesh_at_count(jobs, clean, size, quads, way)
        if "error" not in peer:
            peer.update(quality=jobs.quality(peer["mesh"]),
                        **jobs.against_lines(peer["mesh"], clean, size, peer["shift"]))
        row["gmsh"].append(peer)
    return row


def measure_maps(jobs):
    rows = []
    for name in MAPS[:1] if jobs.quick else MAPS:
        if not jobs.lines(name):
            return None
        mesh, extra = jobs.path(name + ".msh"), jobs.boundary(name)
        done, report = jobs.mesh(jobs.lines(name), mesh, jobs.size(name, 150 if jobs.quick else 600), extra)
        rows.append(beside_gmsh(jobs, name, jobs.lines(name), report, mesh, extra) if report else
                    {"label": name, "error": done.why})
    return rows


def measure_network(jobs):
    """Sizes that give the wanted counts."""
    if not jobs.network:
        return None
    x0, y0, x1, y1 = box_of(jobs.network)
    rows = []
    for count in COUNTS[:1] if jobs.quick else COUNTS:
        mesh = jobs.path("network", f"{count}.msh")
        done, report = jobs.mesh_at_count(jobs.network, mesh, ((x1 - x0) * (y1 - y0) / count) ** 0.5, count)
        rows.append({"wanted": count, **beside_gmsh(jobs, "network", jobs.network, report, mesh)} if report else
                    {"label": "network", "wanted": count, "error": done.why})
    return rows


def measure_improve(jobs):
    """gmsh's quads of the demo section; its blossom ways fail or lose lines where a line ends in a face, so that the
    first four do without dead ends."""
    if not shutil.which("gmsh"):
        return None
    clean, rows = jobs.path("demo_clean.geojson"), []
    jobs.clean(DEMO, clean, DEMO_SIZE)
    cases = [("backbone", kind) for kind in range(4)] + [("faces", 0), ("faces", 2)]
    for shape, kind in cases:
        geo, before, after = (jobs.path(shape, kind, end) for end in (".geo", "before.msh", "after.msh"))
        gmsh_geo.write_geo(clean, geo, DEMO_SIZE, shape, groups=True)
        options = {"Algorithm": 6, "RecombineAll": 1, "RecombinationAlgorithm": kind}
        row = {"recombination": kind, "way": RECOMBINATIONS[kind], "shape": shape}
        rows.append(row)
        done = run(gmsh_command(geo, before, DEMO_SIZE, options, False), jobs.folder, 300)
        if done.code == 0:
            done = run([jobs.quarry, "improve", before, "-o", after, "--threads", "1", "--quiet"], jobs.folder)
        say(f"improve {shape} {kind}: {done.wall:.1f} s" + ("" if done.code == 0 else f", {done.why}"))
        if done.code != 0:
            row["error"] = done.why
            continue
        near = ["--near", repr(1e-6 * DEMO_SIZE)]  # rounding of the coordinates
        row.update(before=jobs.quality(before), after=jobs.quality(after), seconds=done.cpu,
                   kept=jobs.check("kept_lines.py", after, before, *near, "--cells"),
                   sides_before=jobs.check("kept_lines.py", before, before, *near),
                   sides=jobs.check("kept_lines.py", after, before, *near))
    return rows


def measure_threads(jobs):
    cases = []
    if jobs.lines("kb11_traces"):
        cases.append(("kb11_traces", jobs.lines("kb11_traces"), jobs.boundary("kb11_traces"),
                      jobs.size("kb11_traces", 150 if jobs.quick else 300)))
    if jobs.network:
        x0, y0, x1, y1 = box_of(jobs.network)
        cases.append(("network", jobs.network, [], ((x1 - x0) * (y1 - y0) / (10000 if jobs.quick else 55000)) ** 0.5))
    return [time_threads(jobs, *case) for case in cases] or None


def time_threads(jobs, label, lines, extra, size):
    """Jobs on one and two threads in turn, so that what else the machine does falls on both alike."""
    _, without = jobs.mesh(lines, jobs.path(label, "none.vtu"), size, [*extra, "--cleanup", "none"])
    row = {"label": label, "irregular_before_pct": 100 * without["quality"]["valence"]["irregular_share"],
           "cleanup": {}, "rest": {}, "whole": {}}
    runs, digests = {}, {}
    for _ in range(jobs.repeat):
        for threads in THREADS[:2]:
            out = jobs.path(label, f"t{threads}.vtu")
            done, report = jobs.mesh(lines, out, size, extra, threads)
            runs.setdefault(threads, []).append((done, report["times"]))
            digests[threads] = digest(out)
    for threads in THREADS[2:]:
        out = jobs.path(label, f"t{threads}.vtu")
        jobs.mesh(lines, out, size, extra, threads)
        digests[threads] = digest(out)
    for threads, done in runs.items():
        whole = median_run([each for each, _ in done])
        cleaning = sorted(times["clean-up"] for _, times in done)[len(done) // 2]
        rest = sorted(times["total"] - times["clean-up"] for _, times in done)[len(done) // 2]
        # As text: what is kept goes through JSON.
        row["cleanup"][str(threads)], row["rest"][str(threads)] = cleaning, rest
        row["whole"][str(threads)] = {"wall": whole.wall, "cpu": whole.cpu}
    row.update(quads=report["counts"]["quads"], times=report["times"]["of_cleanup"],
               irregular_after_pct=100 * report["quality"]["valence"]["irregular_share"],
               same_bytes=len(set(digests.values())) == 1)
    return row
