"""docs/results.md: the tables of bench/tables.py with the words around them."""
import os

import tables

MISSED_HEADING = "## What was missed and why"

PAGE = """# Results on real maps

Made by `bench/maps.py` (the text at the end apart), which anyone can rerun; do not edit the tables. Five maps that are
not part of this repository: fracture traces of an outcrop within its outline (kb11: 707 lines), lineaments (hastholmen:
516; lineaments: 221; all three are test data of fractopo), a dense trace map with 5,100 dangling ends (souter_all:
2,792, from FracPaQ) and a section through a structural model (section_a1: 13 long lines, from OpenGeode-Inspector). The
size is the wanted edge H: the longer side of the box of the input lines, divided by the number given. Everything else
is the default, but for `--cleanup none`; [results-quads.md](results-quads.md) has quads with clean-up,
[results-cleaning.md](results-cleaning.md) cleaning alone beside GEOS, and [results-networks.md](results-networks.md)
networks beside gmsh. SJ is the scaled Jacobian of a quad, its smallest corner's; irregular are interior vertices with other than four edges. Times are
whole processes, file to file{repeat}.

Machine: {machine}.{load}

## The maps at three sizes

Referee: valid, conforming, complete, every input line within snap + min-edge + tolerance of its own edges, all quads,
longest edge of a face at most 12 times its shortest. Angles in degrees; the input's is the smallest between cleaned
lines that meet, and no mesh can have all faces above it.

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

souter_all, `--elements tri`: shares in % of triangles with Lo's measure below a value. The paper's figures are for a
Delaunay start.

{C}

## A start of four triangles (the paper's Fig. 13)

section_a1 within its box, `--start` with a mesh of four triangles, beside the default start. All lines are to be there
and the mesh valid; four triangles are refined where lines need it and nowhere else, so that H only says how far lines
are simplified.

{F}

## Speed and memory against gmsh

kb11; gmsh gets the lines that `quarry clean` wrote, as one surface for each enclosed face with the dead ends embedded,
and is not charged for cleaning; quarry's time has reading and cleaning of the raw lines in it. The programs run in
turn, one thread each. Splitting each triangle into three quads is gmsh's fastest way, and leaves every second vertex
irregular; the ways that pair triangles give meshes of the kind made here. Ways that leave triangles or inverted quads
(SJ min at most 0) are shown and not counted.

{D}

## Larger meshes

kb11.

{E}

"""


def missing(letter):
    return f"(not measured: `bench/maps.py --tables {letter}`)"


def repeat_text(kept):
    count = kept.get("repeat", 1)
    return f"; medians of {count} runs in the first table and against gmsh" if count > 1 else "; one run each"


def page_text(kept, missed):
    def made(letter, make):
        return make(kept[letter]) if letter in kept else missing(letter)

    loads = [load for load in kept.get("load", {}).values() if load > 0.7]
    load = (f" It was busy with other work (load average up to {max(loads):.1f}): times are too long and uneven."
            if loads else "")
    text = PAGE.format(
        machine=kept["machine"], load=load, repeat=repeat_text(kept), right=tables.RIGHT_SHARE,
        A=made("A", tables.table_a), targets=made("A", tables.targets_a), B=made("B", tables.table_b),
        C=made("C", tables.table_c), D=made("D", tables.table_d), E=made("E", tables.table_e),
        F=made("F", tables.table_f), G=made("G", tables.table_g),
        agreement=made("A", tables.agreement))
    return text + MISSED_HEADING + "\n" + missed


def write(path, kept, text=page_text):
    """Writes the page that text(kept, missed) makes; what stands below the last heading in an older one is kept."""
    missed = "\n"
    if os.path.exists(path):
        with open(path) as file:
            missed = file.read().partition(MISSED_HEADING + "\n")[2] or missed
    with open(path, "w") as file:
        file.write(text(kept, missed))
