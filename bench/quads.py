#!/usr/bin/python3
"""Measures how good the quads are, checks them and writes docs/results-quads.md. From the root of the repository:

  bench/quads.py [--only SECTION,...] [--quick] [--data DIR] [--network FILE.geojson] [--referee DIR]
                 [--quarry build/quarry] [--programs build/bench/bench] [--repeat 3]

--only      measures only these, and takes the others from the measurements that --keep holds; "": only writes the page
--quick     small sizes, few seeds, the page to stdout: to see that everything works
--data      folder with planar/NAME.lines.geojson (the maps are not part of this repository)
--network   a drawn fracture network, for the section of that name; without it that section is left out
--referee   folder with planar_quality.py, an independent checker of the figures; without it they go unchecked
--programs  folder with matching_bench and cleanup_bench (`./run bench` builds them)
--keep      the measurements as JSON; default out/quads.json (out/quads_quick.json)

  matching  time, Steiner points and quality beside Boost's matchings (the paper's tables 1 and 2)
  disks     clean-up of the three-way split of triangulations of a disk (table 4 and section 6.2)
  shapes    domains that can be meshed without any irregular vertex, and one outline of a map
  maps      fracture maps beside gmsh on the same cleaned lines at the same count
  network   the same for a drawn network at three sizes
  improve   `quarry improve` on gmsh's own quads
  threads   how long clean-up takes, on one and two threads, and equal bytes

Nothing else should run on the machine meanwhile. Needs Python 3.9, and numpy and scipy for the checks; gmsh and Boost's
headers where they are there.
"""
import argparse
import json
import os
import tempfile

import page
import quads_page
from jobs import chosen, load_json, machine_text, say, source_commit
from quads_jobs import QuadJobs
from quads_kernels import measure_disks, measure_matching, measure_shapes
from quads_maps import measure_improve, measure_maps, measure_network, measure_threads

SECTIONS = {"matching": measure_matching, "disks": measure_disks, "shapes": measure_shapes, "maps": measure_maps,
            "network": measure_network, "improve": measure_improve, "threads": measure_threads}


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default=",".join(SECTIONS))
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--data", default="../shared/data")
    parser.add_argument("--network")
    parser.add_argument("--referee", default="../shared/referee")
    parser.add_argument("--quarry", default="build/quarry")
    parser.add_argument("--programs", default="build/bench/bench")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--keep")
    parser.add_argument("--out", default="docs/results-quads.md")
    arguments = parser.parse_args()
    arguments.only = chosen(parser, arguments.only, SECTIONS, "sections")
    if not arguments.keep:
        arguments.keep = "out/quads_quick.json" if arguments.quick else "out/quads.json"
    return arguments


def main():
    arguments = parse()
    kept = load_json(arguments.keep) if os.path.exists(arguments.keep) else {}
    kept["machine"] = machine_text()
    os.makedirs(os.path.dirname(arguments.keep) or ".", exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        jobs = QuadJobs(arguments, folder)
        for name in arguments.only:
            say(f"section {name}")
            busy = os.getloadavg()[0]
            measured = SECTIONS[name](jobs)
            if measured is None:
                say(f"section {name}: its input is not at hand")
                continue
            kept[name] = measured
            kept.setdefault("load", {})[name] = busy
            kept.setdefault("commit", {})[name] = source_commit()
            kept["repeat"] = jobs.repeat
            with open(arguments.keep, "w") as file:
                json.dump(kept, file, indent=1)
    if arguments.quick:
        print(quads_page.page_text(kept, ""))
    else:
        page.write(arguments.out, kept, quads_page.page_text)
        say(f"wrote {arguments.out}")


if __name__ == "__main__":
    main()
