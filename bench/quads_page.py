"""docs/results-quads.md: the tables of bench/quads.py with the words around them."""
import quads_map_tables as maps
import quads_tables as kernels
from page import MISSED_HEADING

PAGE = """# How good the quads are

Made by `bench/quads.py` (the text at the end apart), which anyone can rerun; do not edit the tables. Every figure that
has a wanted one beside it says whether it is met, and is rounded away from it. SJ is the scaled Jacobian of a quad, its
smallest corner's; irregular are interior vertices with other than four edges, those on lines among them. The paper is
[Verma & Tautges 2011](bibliography.md). [results.md](results.md) has times, memory and quality without clean-up.

Machine: {machine}.{load} Sources as of {commit}. Seconds of tables 1, 2 and 4 are the processor's on one thread.

## Matching alone (the paper's table 1)

Delaunay triangulations of a square, random points relaxed. Tree: shapes of pairs, short alternating ways, spanning
forest and parity; search: descent over stars, what the default does. Boost: `edmonds_maximum_cardinality_matching`.

{times}

## Steiner points (the paper's table 2)

In % of the nodes. The forest by shapes alone and by short ways, then the search by descent (the default), then with
2,400 sweeps of annealing and a cost of 4 for each Steiner point.

{steiner}

## Clean-up of a disk (the paper's table 4 and section 6.2)

The three-way split of Delaunay triangulations of a disk, half of whose inner vertices are irregular. `full` is the
default, `fewest` allows patches of any size; a disk cannot have fewer than four. Not convex is decided exactly.

{disks}

### What each operator and size class did to a disk

{disk_counts}

## Domains without irregular vertices

The three-way split again, with matching counts on opposite sides or circles: nothing in the domain asks for an
irregular vertex. All boundary vertices are fixed. Boundary edges are as long as the triangles', halved: then a regular
mesh has 58 % of the quads that there are; or as long as the quads: then it has as many.

{domains}

getaberget_area, a circle of 36 sides, as the outline of a whole job:

{outline}

## Fracture maps beside gmsh

Four maps at 1/600 of their longer side (bench/maps.py says where they come from). gmsh meshes the lines that `quarry
clean` wrote, as one surface for each enclosed face with the dead ends embedded; its edge length is set so that it makes
as many quads. First of all, what each kept: bench/kept_lines.py measures how much of each cleaned line's length is
covered by edges of the mesh, within 1 % of the size. It shares no code with quarry.

{map_lines}

Below 0.2: quads with a smaller scaled Jacobian, of which those in a sector between two lines whose own angle is sharp,
with a sine below 0.2, cannot be better. Of the rest, some fill a sector of nearly 180 degrees alone (at flat corners;
its sine is below 0.2, too, but two faces could share it), and some lie elsewhere (bench/poor_faces.py, which shares no
code with quarry either). Off lines: areas of faces that touch no line, irregular vertices on none.

{map_shapes}

{map_targets}

{map_agreement}

### Faces of the maps to look at

{map_faces}

### The smallest and largest faces

{map_areas}

## A drawn network

{network_words}

{network}

## `quarry improve` on gmsh's quads

The demo section at size 6, cleaned, with its lines and outline as physical groups; gmsh's four recombinations of the
faces without dead ends, and the two that finish with them. Before -> after; ok where it is no worse. The tagged edges
of gmsh's file are looked for among those of the improved one, and among the sides of its faces (bench/kept_lines.py).

{improve}

## How long clean-up takes

Medians of {repeat} runs, threads in turn; what the report says of the stages.

{threads}

"""

NETWORK = """A network of 1,000 segments drawn by lot in a square of 1000 units, with lengths of a power law in two or
three directions, four layers, and snapped to a grid of 5 units, meshed at about 25,000, 60,000 and 125,000 quads.
`quarry generate fractures --count 180` draws the like."""


def page_text(kept, missed):
    def made(section, make):
        return make(kept[section]) if section in kept else f"(not measured: `bench/quads.py --only {section}`)"

    def network(rows):
        return "\n\n".join([maps.table_lines(rows), maps.table_shapes(rows), maps.targets_irregular(rows),
                            maps.agreement_text(rows), "### Faces of the network to look at", maps.list_faces(rows),
                            maps.areas_text(rows), "### What each operator and size class did to the network",
                            maps.counts_of_maps(rows)])

    loads = [load for load in kept.get("load", {}).values() if load > 0.7]
    load = (f" It was busy with other work (load average up to {max(loads):.1f}): times are too long and uneven."
            if loads else "")
    text = PAGE.format(
        machine=kept["machine"], load=load, commit=", ".join(sorted(set(kept.get("commit", {}).values()))), repeat=kept.get("repeat", 1), network_words=NETWORK,
        times=made("matching", lambda m: kernels.table_times(m["times"]) + "\n\n" + kernels.targets_times(m)),
        steiner=made("matching", lambda m: kernels.table_steiner(m["steiner"])),
        disks=made("disks", lambda rows: kernels.table_disks(rows) + "\n\n" + kernels.targets_disks(rows)),
        disk_counts=made("disks", kernels.counts_of_disks),
        domains=made("shapes", lambda shapes: kernels.table_domains(shapes["domains"])),
        outline=made("shapes", lambda shapes: kernels.table_outline(shapes["outline"])),
        map_lines=made("maps", maps.table_lines), map_shapes=made("maps", maps.table_shapes),
        map_targets=made("maps", maps.targets_irregular), map_agreement=made("maps", maps.agreement_text),
        map_faces=made("maps", maps.list_faces), map_areas=made("maps", maps.areas_text),
        network=made("network", network),
        improve=made("improve", maps.table_improve), threads=made("threads", maps.table_threads))
    return text + MISSED_HEADING + "\n" + missed
