#!/usr/bin/env python3
"""The kernels alone, without files around them: elements a second on 1, 2, ... threads. Prints a table in
Markdown, or writes it as docs/results-kernels.md.

usage: kernels.py [--programs build/bench/bench] [--threads 1,2] [--only NAME,...] [--filter REGEX] [--quick]
                  [--out docs/results-kernels.md]

--only     of the programs in SOURCES, without _bench: engine, initial, deferred, cluster, smooth, crossfield, mesh_reader,
           mesh_writer, linework, cleanup, matching
--filter   of the benchmarks in programs that have a harness (Google Benchmark), those whose names fit this
--quick    short runs on small input
--out      the page; without it the table is printed

Build the programs before (`./run bench` does, as cmake's preset `bench`). Nothing else should run meanwhile.
"""
import argparse
import json
import os
import re
import subprocess
import tempfile

from jobs import chosen, machine_text, run, say, source_commit
from tables import table, thousands

PAGE = """# Kernels alone

Made by `bench/kernels.py`, which anyone can rerun; do not edit. Each kernel by
itself, on input that is in memory, by the clock; with one thread matching is by processor time. What an element is, the
table says: what a kernel is given, or, of start meshes and insertion, what it makes. Input: networks of `quarry generate
fractures` (bench/synthetic_network), drawn domains (bench/domains), wavy surfaces, random keys and points. Kernels without a figure for
more threads than one are called from within parallel loops. Machine: {machine}. Sources as of {commit}.

{table}
"""

HARNESS = ("engine", "initial", "deferred", "cluster", "smooth", "crossfield", "mesh_reader", "mesh_writer")
# How a benchmark is called, and what it counts, by the beginning of its name.
KERNELS = {"sorted_order_by_radix": ("sorting by radix", "keys"), "run_predicate": ("predicate", "calls"),
           "make_start": ("start mesh", "triangles made"), "insert_network": ("insertion of lines", "attractions"),
           "pair": ("pairing", "triangles"), "recut": ("recutting of mixed meshes", "triangles"),
           "merge_and_halve": ("merging and halving", "triangles"), "smooth_quads": ("smoothing", "quads"),
           "smooth_region": ("smoothing of a region", "vertices"), "field_of_levels": ("fields, levels", "vertices"),
           "field_of_crosses": ("fields, crosses", "vertices"), "field_of_spacing": ("fields, spacing", "vertices"),
           "field_of_positions": ("fields, positions", "vertices"), "quarry_reads": ("reading", "triangles"),
           "quarry_writes": ("writing", "quads")}
UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
PEERS = re.compile("assimp_reads|by_stable_sort")
STEPS = {"shapes_s": "shapes of pairs", "ways_s": "short ways", "forest_s": "spanning forest", "parity_s": "parities",
         "search_s": "search", "merge_s": "merging"}


class Programs:
    def __init__(self, arguments, folder):
        self.arguments, self.folder = arguments, folder
        self.threads = [int(word) for word in arguments.threads.split(",")]

    def path(self, name):
        return os.path.join(self.arguments.programs, name + "_bench")

    def printed(self, name, *arguments):
        """What a program prints, line by line. Its threads: those of the benchmarks that register them."""
        out = os.path.join(self.folder, "printed.txt")
        os.environ["QUARRY_BENCH_THREADS"] = self.arguments.threads
        done = run([self.path(name), *arguments], self.folder, 3600, out)
        say(f"{name} {' '.join(map(str, arguments))}: {done.wall:.1f} s")
        if done.code != 0:
            raise SystemExit(f"{self.path(name)}: {done.why}")
        with open(out) as file:
            return file.read().splitlines()


def of_harness(programs, name):
    """(kernel, size, element, threads, elements a second) of each benchmark of a program."""
    extra = [f"--benchmark_filter={programs.arguments.filter}"] if programs.arguments.filter else []
    extra += ["--benchmark_min_time=0.05"] if programs.arguments.quick else []
    listed = subprocess.run([programs.path(name), "--benchmark_list_tests=true", *extra], capture_output=True, text=True)
    if not any(line and not PEERS.match(line) and "Failed to match" not in line for line in listed.stdout.splitlines()):
        return
    for row in json.loads("\n".join(programs.printed(name, "--benchmark_format=json", *extra)))["benchmarks"]:
        if PEERS.search(row["name"]):
            continue
        base, *parts = row["name"].split("/")
        kernel, element = next(known for start, known in KERNELS.items() if base.startswith(start))
        words, given, threads = [kernel], [], 1
        for part in parts:
            label, colon, value = part.partition(":")
            if label == "threads":
                threads = int(value)
            elif colon and label != "iterations":
                given.append(f"{label} {int(value):,}")
            elif not colon and part != "real_time":
                words.append(part.replace("_", " "))
        yield ", ".join(words), size_of(row, given), element, threads, row["items_per_second"]


def size_of(row, given):
    """Elements a run, and what the benchmark was given."""
    took = row["real_time" if row["name"].endswith("/real_time") else "cpu_time"]
    count = f"{row['items_per_second'] * took * UNITS[row['time_unit']]:,.0f}"
    return f"{count} ({', '.join(given)})" if given and not given[0].endswith(f" {count}") else count


def of_linework(programs):
    repeats, largest = (1, 1e4) if programs.arguments.quick else (3, 1e5)
    for line in programs.printed("linework", repeats, int(largest)):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not cells[0].isdigit():
            continue
        # Segments, crossings, pieces, GEOS; then three columns for each number of threads, seconds first.
        for threads, seconds in zip(programs.threads, cells[4::3]):
            yield "cleaning of lines", f"{int(cells[0]):,}", "segments", threads, int(cells[0]) / float(seconds)


def of_cleanup(programs):
    quads = 5000 if programs.arguments.quick else 50000
    for threads in programs.threads:
        row = json.loads(programs.printed("cleanup", "disk", quads, "full", 1, 1, threads)[-1])
        given = row["before"]["quads"]
        for part in ("operators", "patches", "chords", "smoothing"):
            yield f"clean-up, {part}", f"{given:,} (disk)", "quads", threads, given / row["times"][part]


def of_matching(programs):
    largest = 1e4 if programs.arguments.quick else 1e6
    for threads in programs.threads:
        row = json.loads(programs.printed("matching", "times", largest, threads)[-1])
        for key, what in STEPS.items():
            if row[key] > 0:
                yield f"matching, {what}", f"{row['triangles']:,}", "triangles", threads, row["triangles"] / row[key]


SOURCES = {**{name: (lambda programs, name=name: of_harness(programs, name)) for name in HARNESS},
           "linework": of_linework, "cleanup": of_cleanup, "matching": of_matching}


def measure(programs, only):
    """{(kernel, size, element): {threads: elements a second}} in the order of the programs."""
    rates = {}
    for name in only:
        for kernel, size, element, threads, rate in SOURCES[name](programs):
            rates.setdefault((kernel, size, element), {})[threads] = rate
    return rates


def table_of(rates, threads):
    header = ["kernel", "size", "elements", *(f"{count} thread{'s' if count > 1 else ''}, a second" for count in threads),
              "last by first"]
    body = []
    for key, by_threads in rates.items():
        figures = [thousands(by_threads[count]) if count in by_threads else "" for count in threads]
        first, last = by_threads.get(threads[0]), by_threads.get(threads[-1])
        body.append([*key, *figures, f"{last / first:.2f}" if first and last and len(threads) > 1 else ""])
    return table(header, body)


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", default="build/bench/bench")
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--only", default=",".join(SOURCES))
    parser.add_argument("--filter", default="")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--out", default="")
    arguments = parser.parse_args()
    arguments.only = chosen(parser, arguments.only, SOURCES, "programs")
    return arguments


def main():
    arguments = parse()
    with tempfile.TemporaryDirectory() as folder:
        programs = Programs(arguments, folder)
        kept = {"machine": machine_text(), "commit": source_commit(),
                "table": table_of(measure(programs, arguments.only), programs.threads)}
    if not arguments.out:
        print(kept["table"])
        return
    with open(arguments.out, "w") as file:
        file.write(PAGE.format(**kept))


if __name__ == "__main__":
    main()
