"""The page of bench/networks.py: a table of our own jobs, one of those of gmsh and netgen, one of ratios."""
PAGE = """# Networks of growing size

Made by `bench/networks.py`, which anyone can rerun; do not edit. Fractures drawn by `quarry generate fractures --count N`
in a box of 1000, with lengths by a power law and two sets of directions. Whole processes, file to file, seconds of
processor time (and of the clock in brackets), the best of {repeat}. gmsh and netgen (Debian's both) mesh the lines that
`quarry clean` wrote: gmsh face by face of the arrangement, netgen as one domain with all lines inside it, to an edge that
gives about as many elements; the ways of gmsh are those of [results.md](results.md){ways}. A run of them ends after {limit} s.
netgen makes no meshes of quadrilaterals alone. Machine: {machine}. Sources as of {commit}.

## quarry

| network | what | H | elements | 1 thread s | elements/s | us an element | 2 threads s | 1 by 2, clock | peak MB | bytes an element above 50 MB | SJ min | SJ mean | % below 0.2 | % irregular | same bytes 1, 2 |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|
{ours}

## gmsh and netgen beside it

{peers}

## Ratios

Larger is better in all. `./run bench --compare` measures the first network again and says which of them fell by more than
a fifth since they were recorded (bench/recorded/networks.json).

{ratios}
"""

PEER_HEADING = """| network | who | how | elements | s | elements/s | peak MB | quadrilaterals, triangles | SJ min | SJ mean | % below 0.2 | % irregular |
|---|---|---|---|---|---|---|---|---|---|---|---|"""


def ours_row(row):
    if "error" in row:
        return f"| {row['network']} | {row['what']} | {row['error']} |" + " |" * 13
    count, one, two = row["elements"], row["one"], row["two"]
    return (f"| {row['network']} | {row['what']} | {row['size']:.3g} | {count:,} | {one['cpu']:.2f} ({one['wall']:.2f}) | "
            f"{count / one['cpu']:,.0f} | {1e6 * one['cpu'] / count:.2f} | {two['cpu']:.2f} ({two['wall']:.2f}) | "
            f"{one['wall'] / two['wall']:.2f} | {row['peak'] / 1e6:.0f} | {max(0, row['peak'] - 5e7) / count:.0f} | "
            f"{row['sj_min']:.3f} | {row['sj_mean']:.4f} | {row['below_0.2']:.3f} | {row['irregular']:.2f} | "
            f"{'yes' if row['same_bytes'] else '**no**'} |")


def peer_row(row):
    if "error" in row:
        return f"| {row['network']} | {row['who']} | {row['way']} | {row['error']} |" + " |" * 8
    shape = [f"{row[key]:.4g}" if key in row else "" for key in ("sj_min", "sj_mean", "below_0.2", "irregular")]
    return (f"| {row['network']} | {row['who']} | {row['way']} | {row['elements']:,} | {row['cpu']:.2f} | "
            f"{row['elements'] / row['cpu']:,.0f} | {row['peak'] / 1e6:.0f} | {row['quads']:,}, {row['triangles']:,} | "
            + " | ".join(shape) + " |")


def page(results, repeat, limit, quick):
    peers = "\n".join([PEER_HEADING, *map(peer_row, results["peers"])]) if results["peers"] else "Not run."
    table = ["| ratio | |", "|---|---|", *(f"| {name} | {value:.2f} |" for name, value in results["ratios"].items())]
    return PAGE.format(repeat=repeat, limit=limit, machine=results["machine"], commit=results["commit"],
                       ways=", here the fastest alone" if quick else "",
                       ours="\n".join(map(ours_row, results["quarry"])), peers=peers, ratios="\n".join(table))
