"""Tables from the measurements of bench/quads.py on drawn meshes: each figure with its target and whether it is met."""
import math

from tables import table, thousands, verdict

PAPER_STEINER = "3.7 to 3.9"
# Table 4, all parts together.
PAPER_SECONDS = {5000: 3.9, 10000: 11.5, 50000: 986}


def at_least(value, wanted, digits):
    """Rounded down, so that what is printed is never better than what was measured."""
    shown = math.floor(value * 10**digits) / 10**digits
    return f"{shown:.{digits}f} >= {wanted}: {verdict(value >= wanted)}"


def at_most(value, wanted, digits):
    """Rounded up."""
    shown = math.ceil(value * 10**digits) / 10**digits
    return f"{shown:.{digits}f} <= {wanted}: {verdict(value <= wanted)}"


def below(value, wanted, digits):
    shown = math.ceil(value * 10**digits) / 10**digits
    return f"{shown:.{digits}f} < {wanted}: {verdict(value < wanted)}"


def exactly(value, wanted):
    return f"{value} = {wanted}: {verdict(value == wanted)}"


def seconds(value):
    return f"{value:.4f}" if value < 1 else f"{value:.2f}"


def table_times(rows):
    header = ["triangles", "shapes s", "short ways s", "forest s", "parity s", "tree s", "search s", "tree + search s",
              "Steiner, % of nodes", "SJ mean", "SJ min", "Boost s", "Boost / tree", "Boost / (tree + search)"]
    body = []
    for row in rows:
        whole = row["tree_s"] + row["search_s"]
        boost = row.get("cardinality")
        peer = [""] * 3
        if boost:
            peer = [seconds(boost["s"]), f"{boost['s'] / row['tree_s']:.0f}", f"{boost['s'] / whole:.0f}"]
        body.append([thousands(row["triangles"]), *[seconds(row[f"{part}_s"]) for part in
                     ("shapes", "ways", "forest", "parity", "tree", "search")], seconds(whole),
                     f"{row['steiner_pct']:.2f}", f"{row['mean']:.4f}", f"{row['smallest']:.3f}", *peer])
    return table(header, body)


def find_times(rows, about):
    return next((row for row in rows if 0.9 < row["triangles"] / about < 1.1), None)


def targets_times(matching):
    rows, one = matching["times"], matching["weighted"]
    lines = []
    large, million, peer = (find_times(rows, about) for about in (1e7, 1e6, 1e5))
    if large and million:
        for label, parts in (("tree and search", ("tree_s", "search_s")), ("tree alone", ("tree_s",))):
            factor = sum(large[p] for p in parts) / sum(million[p] for p in parts)
            lines.append(f"- Ten million triangles against one million, {label}, times as long: "
                         f"{at_most(factor, 12, 2)}")
    if peer and "cardinality" in peer:
        boost = peer["cardinality"]["s"]
        for label, took in (("tree and search", peer["tree_s"] + peer["search_s"]), ("tree alone", peer["tree_s"])):
            lines.append(f"- Boost's maximum cardinality matching at {thousands(peer['triangles'])} triangles against "
                         f"{label}, times as long: {at_least(boost / took, 100, 1)}")
    if "weighted" in one:
        boost = one["weighted"]
        lines.append(f"- Mean scaled Jacobian at {thousands(one['triangles'])} triangles beside Boost's maximum "
                     f"weighted matching ({one['mean']:.4f} beside {boost['mean']:.4f}), share of it: "
                     f"{at_least(one['mean'] / boost['mean'], 0.99, 4)}. The weighted matching takes "
                     f"{boost['s']:.1f} s, leaves {one['triangles'] - 2 * boost['pairs']} triangles and a smallest "
                     f"scaled Jacobian of {boost['smallest']:.3f}; tree and search take {one['tree_s'] + one['search_s']:.4f} s and leave "
                     f"{one['steiner']} Steiner points and {one['smallest']:.3f}.")
    return "\n".join(lines) or "Boost's headers were not at hand."


def table_steiner(rows):
    header = ["points", "nodes", "forest by shapes", "by short ways", "descent", "s", "SJ mean", "annealing", "s",
              "SJ mean", "paper"]
    body = []
    for row in (r for r in rows if r["way"] == "shapes"):
        same = {r["way"]: r for r in rows if (r["points"], r["nodes"]) == (row["points"], row["nodes"])}
        descent, annealing = same["descent"], same["annealing"]
        body.append([row["points"], thousands(row["nodes"]), f"{row['steiner_pct']:.2f}",
                     f"{same['short ways']['steiner_pct']:.2f}", at_most(descent["steiner_pct"], 1.5, 2),
                     seconds(descent["search_s"]), f"{descent['mean']:.4f}", at_most(annealing["steiner_pct"], 0.4, 2),
                     seconds(annealing["search_s"]), f"{annealing['mean']:.4f}", PAPER_STEINER])
    return table(header, body)


def table_disks(rows):
    header = ["quads", "% irregular", "level", "seed", "quads after", "irregular", "%", "not convex", "SJ mean",
              "SJ min", "s", "paper s"]
    body = []
    for row in rows:
        before, after, full = row["before"], row["after"], row["level"] == "full"
        body.append([thousands(before["quads"]), f"{before['irregular_pct']:.1f}", row["level"], row["seed"],
                     thousands(after["quads"]), after["irregular"] if full else exactly(after["irregular"], 4),
                     below(after["irregular_pct"], 0.5, 3) if full else f"{after['irregular_pct']:.3f}",
                     exactly(after["not_convex"], 0),
                     at_least(after["mean"], 0.99, 4) if full else f"{after['mean']:.4f}",
                     f"{after['smallest']:.3f}", f"{row['cpu_s']:.2f}", PAPER_SECONDS.get(row["about"], "")])
    return table(header, body)


def targets_disks(rows):
    times = {}
    for row in (r for r in rows if r["level"] == "full"):
        times.setdefault(row["about"], []).append(row["cpu_s"])
    lines = []
    if 50000 in times:
        slowest = max(times[50000])
        lines.append(f"- Seconds at about 50,000 quads, the slowest seed: {below(slowest, 1.5, 2)}; a hundredth of the "
                     f"paper's: {below(slowest, 9.5, 2)}")
    if {50000, 500000} <= times.keys():
        factor = max(times[500000]) / min(times[50000])
        lines.append(f"- About 500,000 quads against 50,000, the quickest seed, times as long: "
                     f"{at_most(factor, 12, 2)}")
    return "\n".join(lines)


def named_counts(counts):
    return ", ".join(f"{name.replace('_', ' ')} {thousands(count)}" for name, count in counts.items() if count) or "-"


def table_operators(cleanup, times):
    header = ["operator", "looked at", "tried", "won", "rejected", "s"]
    body = [[each["name"], thousands(each["looked_at"]), thousands(each["tried"]), thousands(each["won"]),
             named_counts(each["rejected"]), f"{times[each['name']]:.3f}"] for each in cleanup["operators"]]
    return table(header, body)


def table_patches(cleanup, times):
    header = ["largest", "seeds", "searches", "convex stages", "tried", "won", "of them", "stages and fills rejected",
              "search s", "commit s"]
    body = []
    for each in cleanup["patches"]:
        lines = " over lines" if each["over_lines"] else ""
        took = times[f"patches of {each['largest']}{lines}"]
        body.append([thousands(each["largest"]) + lines, thousands(each["seeds"]), thousands(each["searches"]),
                     thousands(each["convex_stages"]), thousands(sum(each["tried"].values())),
                     thousands(sum(each["won"].values())), named_counts(each["won"]), named_counts(each["rejected"]),
                     f"{took['search']:.3f}", f"{took['commit']:.3f}"])
    return table(header, body)


def counts_of(label, row):
    """Both tables of counts of one clean-up."""
    times = row["times"]
    return (f"{label}: {times['operators']:.2f} s on operators, {times['patches']:.2f} s on patches, "
            f"{times['smoothing']:.2f} s on smoothing.\n\n" + table_operators(row["cleanup"], times) + "\n\n" +
            table_patches(row["cleanup"], times))


def counts_of_disks(rows):
    """Of the largest disk up to 50,000 quads of each level, first seed."""
    chosen = []
    for level in ("full", "fewest"):
        same = [row for row in rows if row["level"] == level and row["about"] <= 50000]
        if same:
            row = max(same, key=lambda r: (r["about"], -r["seed"]))
            chosen.append(counts_of(f"{thousands(row['before']['quads'])} quads, `{level}`, seed {row['seed']}", row))
    return "\n\n".join(chosen)


def table_domains(rows):
    header = ["domain", "boundary edges", "quads", "level", "seed", "quads after", "irregular inside", "not convex",
              "SJ mean", "SJ min", "s"]
    body = [[row["domain"], "as triangles" if row["boundary_spacing"] == 1 else "as quads",
             thousands(row["before"]["quads"]), row["level"], row["seed"], thousands(row["after"]["quads"]),
             # The demand is on as few as can be had.
             exactly(row["after"]["irregular"], 0) if row["level"] == "fewest" else row["after"]["irregular"],
             exactly(row["after"]["not_convex"], 0), f"{row['after']['mean']:.4f}", f"{row['after']['smallest']:.3f}",
             f"{row['cpu_s']:.2f}"] for row in rows]
    return table(header, body)


def table_outline(rows):
    header = ["longer side /", "level", "quads", "irregular inside", "SJ mean", "SJ min", "s"]
    body = []
    for row in rows:
        if "error" in row:
            body.append([row["division"], row["level"], row["error"], *[""] * 4])
            continue
        quality = row["quality"]
        body.append([row["division"], row["level"], thousands(quality["quads"]), at_most(row["irregular"], 8, 0),
                     f"{quality['scaled_jacobian']['mean']:.4f}", f"{quality['scaled_jacobian']['min']:.3f}",
                     f"{row['seconds']:.2f}"])
    return table(header, body)
