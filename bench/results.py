"""Turns the measurements of bench/maps.py into docs/results.md: every figure with its target and whether it is met."""
import os

MISSED_HEADING = "## What was missed and why"
SHORT = {"kb11_traces": "kb11", "hastholmen_traces": "hastholmen", "souter_all": "souter_all",
         "lineaments_200k": "lineaments", "section_model_a1_x2500": "section_a1"}
# Shares of triangles below 0.4 ... 0.9 of Lo's measure, in %: Fig. 9 of the paper, summed.
LO_LIMITS = (0.1, 0.5, 1.7, 5.0, 12.1, 42.4)
RIGHT_SHARE = 59.0  # Fig. 12: % of smallest angles in 80 to 90


def verdict(met):
    return "ok" if met else "**miss**"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def failed_row(row, label, width):
    return [*label, row["error"], *[""] * (width - len(label) - 1)]


def thousands(number):
    return f"{number:,.0f}"


def angles(quality):
    histogram = quality["min_angle"]["histogram_10_degrees"]
    return [100 * count / max(1, sum(histogram)) for count in histogram]


def right_share(row):
    return angles(row["quality"])[-1]


def angle_pair(row):
    return row["quality"]["min_angle"]["min"], row["counts"]["smallest_line_angle"]


def angle_limit(row):
    """0.9 of the smallest input angle, or 20 degrees if that is smaller."""
    return min(0.9 * row["counts"]["smallest_line_angle"], 20.0)


def checked(row):
    if "failed" not in row:
        return "not at hand"
    return "ok" if not row["failed"] else "**" + "; ".join(row["failed"]) + "**"


def memory_limit(quads):
    return 200 * quads + 50e6


def megabytes(count):
    return f"{count / 1e6:.0f}"


def table_a(rows):
    header = ["map", "longer side /", "quads", "SJ min", "SJ mean", "% < 0.2", "smallest angle / input's", "% in 80-90",
              "% irregular", "aspect max", "fallbacks", "s, 1 thread", "quads/s", "peak MB (limit)", "referee `failed`",
              "same bytes 1, 2, 4, 7"]
    body = []
    for row in rows:
        label = [SHORT[row["map"]], row["division"]]
        if "error" in row:
            body.append(failed_row(row, label, len(header)))
            continue
        quality, counts = row["quality"], row["counts"]
        jacobian = quality["scaled_jacobian"]
        body.append([*label, thousands(counts["quads"]), f"{jacobian['min']:.3f}", f"{jacobian['mean']:.4f}",
                     f"{100 * jacobian['share_below_0.2']:.3f}", "{:.2f} / {:.2f}".format(*angle_pair(row)),
                     f"{right_share(row):.1f}", f"{100 * quality['valence']['irregular_share']:.1f}",
                     f"{quality['aspect']['max']:.1f}", counts["fallbacks"], f"{row['wall']:.2f}",
                     thousands(counts["quads"] / row["wall"]),
                     f"{megabytes(row['peak'])} ({megabytes(memory_limit(counts['quads']))})", checked(row),
                     verdict(row["same_bytes"])])
    return table(header, body)


def targets_a(rows):
    """The demands at the finest size, one row a map."""
    finest = max(row["division"] for row in rows)
    header = ["map", "SJ mean", "% below 0.2", "smallest angle", "% irregular", "longest / shortest edge", "peak memory"]
    body = []
    for row in (r for r in rows if r["division"] == finest):
        if "error" in row:
            body.append(failed_row(row, [SHORT[row["map"]]], len(header)))
            continue
        souter, quality = row["map"] == "souter_all", row["quality"]
        jacobian, low = quality["scaled_jacobian"], 100 * quality["scaled_jacobian"]["share_below_0.2"]
        mean_wanted, irregular_wanted = (0.93, 10) if souter else (0.97, 5)
        irregular, aspect = 100 * quality["valence"]["irregular_share"], quality["aspect"]["max"]
        smallest, limit = angle_pair(row)[0], angle_limit(row)
        room = memory_limit(row["counts"]["quads"])
        body.append([
            SHORT[row["map"]],
            f"{jacobian['mean']:.4f} >= {mean_wanted}: {verdict(jacobian['mean'] >= mean_wanted)}",
            f"{low:.3f} <= 0.02: {verdict(low <= 0.02)}",
            f"{smallest:.2f} >= {limit:.2f}: {verdict(smallest >= limit)}",
            f"{irregular:.2f} <= {irregular_wanted}: {verdict(irregular <= irregular_wanted)}",
            f"{aspect:.1f} <= 12: {verdict(aspect <= 12)}",
            f"{megabytes(row['peak'])} <= {megabytes(room)} MB: {verdict(row['peak'] <= room)}"])
    return table(header, body)


def agreement(rows):
    """The largest difference between the report's figures and those of the independent checker."""
    worst = 0.0
    seen = 0
    for row in rows:
        other = row.get("referee_quality")
        if "error" in row or not other:
            continue
        seen += 1
        own = row["quality"]
        worst = max(worst, abs(own["scaled_jacobian"]["min"] - other["scaled_jacobian"]["min"]),
                    abs(own["scaled_jacobian"]["mean"] - other["scaled_jacobian"]["mean"]),
                    abs(own["min_angle"]["min"] - other["min_angle"]["min"]),
                    abs(own["aspect"]["max"] - other["aspect_max_over_min_edge"]["max"]))
    if not seen:
        return "The independent checkers were not at hand."
    return (f"The figures are those of `--report`. On {seen} meshes the smallest and mean scaled Jacobian, smallest angle and "
            f"largest aspect differ from the referee's planar_quality.py by at most {worst:.1g}.")


def table_b(rows):
    header = ["map", "longer side /", "preset", "quads", "fallbacks", "splits", "SJ min", "SJ mean", "% < 0.2",
              "% irregular", "aspect max", "s, 1 thread"]
    body = []
    for row in rows:
        label = [SHORT[row["map"]], row["division"], row["preset"]]
        if "error" in row:
            body.append(failed_row(row, label, len(header)))
            continue
        jacobian, counts = row["quality"]["scaled_jacobian"], row["counts"]
        body.append([*label, thousands(counts["quads"]), thousands(counts["fallbacks"]), thousands(counts["splits"]),
                     f"{jacobian['min']:.3f}", f"{jacobian['mean']:.4f}", f"{100 * jacobian['share_below_0.2']:.3f}",
                     f"{100 * row['quality']['valence']['irregular_share']:.1f}",
                     f"{row['quality']['aspect']['max']:.1f}", f"{row['wall']:.2f}"])
    return table(header, body)


def table_c(rows):
    header = ["start", "triangles", *[f"< 0.{i}" for i in range(4, 10)], "smallest", "s", "referee `failed`"]
    body = [["wanted, at most", "", *[f"{limit}" for limit in LO_LIMITS], "", "", ""]]
    for row in rows:
        if "error" in row:
            body.append(failed_row(row, [row["start"]], len(header)))
            continue
        histogram = row["quality"]["lo_measure"]["histogram_0.1"]
        total = row["quality"]["faces"]
        shares = [100 * sum(histogram[:i]) / total for i in range(4, 10)]
        cells = [f"{share:.2f} {verdict(share <= limit)}" for share, limit in zip(shares, LO_LIMITS)]
        body.append([row["start"], thousands(total), *cells, f"{row['quality']['lo_measure']['min']:.3f}",
                     f"{row['wall']:.2f}", checked(row)])
    return table(header, body)


def table_d(facts):
    if "error" in facts:
        return f"The job failed: {facts['error']}"
    quads, one, two = facts["quads"], facts["one"], facts["two"]
    own = facts["ours"]["quality"]
    header = ["program", "quads", "s wall", "s cpu", "quads/s", "quarry is faster by", "peak MB", "SJ min", "SJ mean",
              "% irregular"]
    shape = [f"{own['scaled_jacobian']['min']:.3f}", f"{own['scaled_jacobian']['mean']:.4f}",
             f"{100 * own['valence']['irregular_share']:.1f}"]
    body = [[f"quarry, {name}", thousands(quads), f"{run['wall']:.2f}", f"{run['cpu']:.2f}", thousands(quads / run["wall"]),
             "", megabytes(run["peak"]), *shape] for name, run in (("1 thread", one), ("2 threads", two))]
    for row in facts["gmsh"]:
        if "error" in row:
            body.append(failed_row(row, [f"gmsh, {row['way']}"], len(header)))
            continue
        theirs = row.get("quality", {})
        rate = row["quads"] / row["wall"]
        jacobian = theirs.get("scaled_jacobian", {"min": float("nan"), "mean": float("nan")})
        body.append([f"gmsh, {row['way']} (h = {row['length']:.2f} H)" + ("" if not row["triangles"] else
                     f", {row['triangles']} triangles left"), thousands(row["quads"]), f"{row['wall']:.2f}",
                     f"{row['cpu']:.2f}", thousands(rate), f"{quads / one['wall'] / rate:.1f}", megabytes(row["peak"]),
                     f"{jacobian['min']:.3f}", f"{jacobian['mean']:.4f}", f"{theirs.get('irregular_pct', float('nan')):.1f}"])
    return table(header, body) + "\n\n" + targets_d(facts)


def targets_d(facts):
    quads, one, two = facts["quads"], facts["one"], facts["two"]
    lines = []
    # All quads, all valid, all lines: what quarry promises as well.
    whole = [row for row in facts["gmsh"] if "error" not in row and row["shape"] == "faces" and not row["triangles"]
             and row.get("quality", {}).get("inverted", 0) == 0]
    for label, chosen in (("fastest way of all that is valid on these lines", whole),
                          ("fastest such way that pairs triangles", [r for r in whole if "RecombineAll" in r["options"]])):
        if not chosen:
            continue
        best = max(chosen, key=lambda row: row["quads"] / row["cpu"])
        factor = quads / one["wall"] / (best["quads"] / best["wall"])
        in_cpu = quads / one["cpu"] / (best["quads"] / best["cpu"])
        lines.append(f"- Quads a second, one thread, against gmsh's {label} ({best['way']}): {factor:.1f} times "
                     f"({in_cpu:.1f} by processor time); wanted 5: {verdict(factor >= 5)}")
    speedup = one["wall"] / two["wall"]
    lines.append(f"- Two threads against one: {speedup:.2f} times faster; wanted 1.6: {verdict(speedup >= 1.6)}")
    room = memory_limit(quads)
    lines.append(f"- Peak memory: {megabytes(one['peak'])} MB with one thread, {megabytes(two['peak'])} with two; wanted at "
                 f"most {megabytes(room)}: {verdict(max(one['peak'], two['peak']) <= room)}")
    return "\n".join(lines)


def table_e(rows):
    header = ["longer side /", "threads", "quads", "s", "s cpu", "quads/s", "faster than 1 thread", "peak MB",
              "bytes a quad above 50 MB", "same bytes"]
    body, alone = [], {}
    for row in rows:
        label = [row["division"], row["threads"]]
        if "error" in row:
            body.append(failed_row(row, label, len(header)))
            continue
        quads = row["counts"]["quads"]
        first = alone.setdefault(row["division"], row)
        body.append([*label, thousands(quads), f"{row['wall']:.2f}", f"{row['cpu']:.2f}", thousands(quads / row["wall"]),
                     f"{first['wall'] / row['wall']:.2f}", megabytes(row["peak"]),
                     f"{max(0.0, row['peak'] - 50e6) / quads:.0f}", verdict(row["digest"] == first["digest"])])
    return table(header, body)


def table_f(rows):
    header = ["start", "longer side /", "quads", "SJ min", "SJ mean", "% < 0.2", "% irregular", "s", "referee `failed`"]
    body = []
    for row in rows:
        label = [row["start"], row["division"]]
        if "error" in row:
            body.append(failed_row(row, label, len(header)))
            continue
        jacobian = row["quality"]["scaled_jacobian"]
        body.append([*label, thousands(row["counts"]["quads"]), f"{jacobian['min']:.3f}", f"{jacobian['mean']:.4f}",
                     f"{100 * jacobian['share_below_0.2']:.3f}",
                     f"{100 * row['quality']['valence']['irregular_share']:.1f}", f"{row['wall']:.2f}", checked(row)])
    return table(header, body)


def table_g(rows):
    header = ["map", "longer side /", *[f"{i}-{i + 10}" for i in range(0, 90, 10)], f"80-90 >= {RIGHT_SHARE:.0f}"]
    body = []
    for row in rows:
        label = [SHORT[row["map"]], row["division"]]
        if "error" in row:
            body.append(failed_row(row, label, len(header)))
            continue
        shares = angles(row["quality"])
        body.append([*label, *[f"{share:.2f}" for share in shares[:-1]], f"{shares[-1]:.1f}",
                     verdict(shares[-1] >= RIGHT_SHARE)])
    return table(header, body)


def missing(letter):
    return f"(not measured: `bench/maps.py --tables {letter}`)"


PAGE = """# Results on real maps

Made by `bench/maps.py` (the text at the end apart), which anyone can rerun; do not edit the tables. Five maps that are not part of
this repository: fracture traces of an outcrop (kb11, within its outline), lineaments of an island (hastholmen) and a
country (lineaments), a dense trace map with 2,792 lines and 5,100 dangling ends (souter_all), a geological section
(section_a1). The size is the wanted edge H: the longer side of the box of the input lines, divided by the number given. Everything else is
the default: no topological clean-up. SJ is the scaled Jacobian of a quad, its smallest corner's; irregular are interior vertices with
other than four edges. Times are whole processes, file to file{repeat}.

Machine: {machine}.{load}

## The maps at three sizes

Referee: valid, conforming, complete, every input line within snap + min-edge + tolerance of its own edges, all quads, longest edge of a face at most 12
times its shortest. Angles in degrees; the input's is the smallest between cleaned lines that meet, and no mesh can have all faces above it.

{A}

### Against the targets at the finest size

{targets}

{agreement}

## Smallest angles (the paper's Fig. 12)

Shares of quads in %, by smallest angle; at least {right:.0f} % between 80 and 90 degrees are wanted.

{G}

## The published procedure beside the default

`--preset paper`: fixed limits, ten sweeps of the 1/length umbrella, alignment fronts; with the same guarantees.

{B}

## Triangles (the paper's Fig. 9)

souter_all, `--elements tri`: shares in % of triangles with Lo's measure below a value. The paper's figures are for a Delaunay start.

{C}

## A start of four triangles (the paper's Fig. 13)

section_a1 within its box, `--start` with a mesh of four triangles, beside the default start. All lines are to be there and the mesh valid; four
triangles are refined where lines need it and nowhere else, so that H only says how far lines are simplified.

{F}

## Speed and memory against gmsh

kb11; gmsh gets the lines that `quarry clean` wrote, as one surface for each enclosed face with the dead ends embedded, and is not charged
for cleaning; quarry's time has reading and cleaning of the raw lines in it. The programs run in turn, one thread each; medians. Splitting each triangle into three
quads is gmsh's fastest way, and leaves every second vertex irregular; the ways that pair triangles give meshes of the kind made here. Ways
that leave triangles or inverted quads (SJ min at most 0) are shown and not counted.

{D}

## Larger meshes

kb11.

{E}

"""


def page(kept, missed):
    def made(letter, make):
        return make(kept[letter]) if letter in kept else missing(letter)

    loads = [load for load in kept.get("load", {}).values() if load > 0.7]
    load = (f" It was busy with other work (load average up to {max(loads):.1f}): times are too long and uneven."
            if loads else "")
    text = PAGE.format(
        machine=kept["machine"], load=load, repeat=", medians of three in the first table", right=RIGHT_SHARE,
        A=made("A", table_a), targets=made("A", targets_a), B=made("B", table_b), C=made("C", table_c),
        D=made("D", table_d), E=made("E", table_e), F=made("F", table_f), G=made("G", table_g),
        agreement=made("A", agreement))
    return text + MISSED_HEADING + "\n" + missed


def write(path, kept):
    """Writes the page; what stands below the last heading in an older one is kept."""
    missed = "\n"
    if os.path.exists(path):
        with open(path) as file:
            missed = file.read().partition(MISSED_HEADING + "\n")[2] or missed
    with open(path, "w") as file:
        file.write(page(kept, missed))
