"""Sections of bench/quads.py on drawn meshes: matching alone, and clean-up of simple domains."""

# (about how many quads, level, seeds)
DISKS = ((5000, "full", (1, 2, 3, 4, 5)), (10000, "full", (1, 2, 3)), (50000, "full", (1, 2)), (500000, "full", (1,)),
         (5000, "fewest", (1, 2, 3, 4, 5)), (10000, "fewest", (1, 2, 3, 4, 5)), (50000, "fewest", (1, 2)),
         (500000, "fewest", (1,)))
QUICK_DISKS = ((5000, "full", (1, 2)), (5000, "fewest", (1, 2)))
DOMAINS = ("square", "annulus", "l-shape")
# Of boundary points, in terms of the triangles' spacing. A triangle of edge 1 makes three quads as large as squares of
# edge 0.38, and halves its boundary edges: with 0.76 a regular mesh has as many quads as there are, with 1 only 58 %.
SPACINGS = (1, 0.76)
LEVELS = ("full", "fewest")
OUTLINE = "getaberget_area"


def measure_matching(jobs):
    return {"times": jobs.rows("matching_bench", "times", 1e5 if jobs.quick else 1e7),
            "weighted": jobs.rows("matching_bench", "weighted", 1e7)[0],
            "steiner": jobs.rows("matching_bench", "steiner", 3e3 if jobs.quick else 1e5)}


def measure_disks(jobs):
    return [{"about": quads, **jobs.rows("cleanup_bench", "disk", quads, level, seed)[0]}
            for quads, level, seeds in (QUICK_DISKS if jobs.quick else DISKS) for seed in seeds]


def measure_shapes(jobs):
    rows = [jobs.rows("cleanup_bench", domain, quads, level, seed, spacing)[0]
            for domain in DOMAINS for quads in ((2000,) if jobs.quick else (2000, 5000, 20000)) for spacing in SPACINGS
            for level in LEVELS for seed in ((1,) if jobs.quick or level == "full" else (1, 2, 3))]
    return {"domains": rows, "outline": measure_outline(jobs) if jobs.lines(OUTLINE) else []}


def measure_outline(jobs):
    rows = []
    for division in (50,) if jobs.quick else (50, 100, 150):
        for level in LEVELS:
            done, report = jobs.mesh(jobs.lines(OUTLINE), jobs.path(OUTLINE, division, level + ".vtu"),
                                     jobs.size(OUTLINE, division), ["--cleanup", level])
            row = {"division": division, "level": level}
            if report is None:
                row["error"] = done.why
            else:
                valence = report["quality"]["valence"]
                row.update(quality=report["quality"], seconds=done.cpu,
                           irregular=round(valence["irregular_share"] * valence["interior_vertices"]))
            rows.append(row)
    return rows
