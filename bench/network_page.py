"""The page of bench/networks.py: a table of our own jobs, one of those of gmsh and netgen, one of ratios."""
import ratios
from page import MISSED_HEADING
from tables import table, thousands, verdict

PAGE = """# Networks of growing size

Made by `bench/networks.py` (the text at the end apart), which anyone can rerun; do not edit the tables. Fractures drawn by
`quarry generate fractures --count N` in a box of 1000, with lengths by a power law and two sets of directions; and the lines of
real maps (bench/maps.py says where they come from) at a 600th of their longer side. Whole
processes, file to file, seconds of processor time (and of the clock in brackets), the best of as many runs as the last column says. gmsh and netgen
(Debian's both) mesh the lines that `quarry clean` wrote: gmsh face by face of the arrangement, netgen as one domain with all
lines inside it, to an edge that gives about as many elements; the ways of gmsh are those of [results.md](results.md), and
its pairings with nothing after them. netgen makes no meshes of quadrilaterals
alone. Lines kept is the share of the cleaned lines' length that lies under edges of the mesh, within {near:.0%} of H,
as near as edges are promised to be (bench/kept_lines.py). Machine: {machine}. The last column has the
version that made a row; it is that of quarry beside which a peer ran.

## quarry

{ours}

## gmsh and netgen beside it

A way counts in the ratios if it comes to its end with elements of one kind alone, none of them inverted (SJ min above 0, of
quadrilaterals), and all lines are kept.

{peers}

## Ratios

Larger is better in all. `./run bench --compare` measures the first network again and says which of them fell by more than
a fifth since they were recorded (bench/recorded/networks.json).

{ratios}

"""

OURS = ["network", "what", "finished", "lines kept %", "H", "elements", "1 thread s", "elements/s", "us an element",
        "2 threads s", "1 by 2, clock", "peak MB", "bytes an element above 50 MB", "SJ min", "SJ mean", "% below 0.2",
        "% irregular", "same bytes 1, 2", "made at"]
PEERS = ["network", "who", "how", "finished", "counted", "lines kept %", "elements", "s", "elements/s", "peak MB",
         "quadrilaterals, triangles", "SJ min", "SJ mean", "% below 0.2", "% irregular", "made at"]


def padded(cells, header, row):
    return [*cells, *[""] * (len(header) - len(cells) - 1), row["made"]]


def kept(row):
    return "" if row.get("kept") is None else f"{row['kept']:.2f}"


def ours_row(row):
    if "error" in row:
        return padded([row["network"], row["what"], f"**no**: {row['error']}"], OURS, row)
    count, one, two = row["elements"], row["one"], row["two"]
    return [row["network"], row["what"], "yes", kept(row), f"{row['size']:.3g}", thousands(count),
            f"{one['cpu']:.2f} ({one['wall']:.2f})", thousands(count / one["cpu"]), f"{1e6 * one['cpu'] / count:.2f}",
            f"{two['cpu']:.2f} ({two['wall']:.2f})", f"{one['wall'] / two['wall']:.2f}", f"{row['peak'] / 1e6:.0f}",
            f"{max(0, row['peak'] - 5e7) / count:.0f}", f"{row['sj_min']:.3f}", f"{row['sj_mean']:.4f}",
            f"{row['below_0.2']:.3f}", f"{row['irregular']:.2f}", "yes" if row["same_bytes"] else "**no**", row["made"]]


def peer_row(row):
    if "error" in row:
        return padded([row["network"], row["who"], row["way"], row["error"], "no"], PEERS, row)
    why = ratios.why_not_counted(row)
    return [row["network"], row["who"], row["way"], "yes", f"no: {why}" if why else "yes", kept(row),
            thousands(row["elements"]), f"{row['cpu']:.2f}", thousands(row["elements"] / row["cpu"]),
            f"{row['peak'] / 1e6:.0f}", f"{row['quads']:,}, {row['triangles']:,}",
            *(f"{row[key]:.4g}" if key in row else "" for key in ("sj_min", "sj_mean", "below_0.2", "irregular")),
            row["made"]]


def ratio_row(name, value):
    asked = ratios.wanted(name)
    number = thousands if value > 1000 else "{:.2f}".format
    return [name, number(value), *(["", ""] if asked is None else [f"{asked:,}", verdict(value >= asked)])]


def page_text(results, missed):
    figures = {**results["ratios"], **results["rates"]}
    text = PAGE.format(
        machine=results["machine"], near=results["near"],
        ours=table(OURS, map(ours_row, results["quarry"])),
        peers=table(PEERS, map(peer_row, results["peers"])) if results["peers"] else "Not run.",
        ratios=table(["ratio", "", "wanted", ""], [ratio_row(*item) for item in figures.items()]))
    return text + MISSED_HEADING + "\n" + missed
