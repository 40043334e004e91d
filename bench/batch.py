#!/usr/bin/env python3
"""Measures `quarry batch` on many small sections.

Draws sections with seeds, meshes each alone on one thread (the sum of those times is what there is to do), then all of
them by `quarry batch` on every core, and once more with three bad ones among them: one that crashes (it is sent a
segmentation fault), one that hangs (its input is a pipe that nobody writes to) and one that takes too much memory. Prints
tables in Markdown, as they stand in docs/results-batch.md. Ends with 1 where a planted job has another outcome than it
should, or one of the others is not done with the bytes that it has alone.

usage: batch.py [--quarry build/quarry] [--sections 200] [--lines 40] [--size 25] [--rounds 3] [--quick]
"""
import argparse
import os
import pathlib
import signal
import statistics
import sys
import tempfile
import threading
import time

import jobs

PLANTED = {"crash": "crashed", "hang": "out of time", "hog": "out of memory"}
ROOT = pathlib.Path(__file__).resolve().parent.parent


def draw(quarry, folder, count, lines):
    os.makedirs(folder)
    for seed in range(count):
        jobs.run([quarry, "generate", "fractures", "--count", lines, "--outline", "--seed", seed, "-q", "-o",
                  os.path.join(folder, f"section_{seed:03}.geojson")], folder)
    os.remove(os.path.join(folder, "stderr.txt"))


def alone(quarry, inputs, work, size):
    """Wall and processor time of all sections, one after the other on one thread each, as a batch would run them."""
    wall = cpu = 0
    for path in inputs:
        out = os.path.join(work, os.path.basename(path))
        done = jobs.run([quarry, "mesh", path, "-o", out + ".vtu", "--report", out + ".json", "--size", size,
                         "--threads", 1], work)
        if done.code:
            sys.exit(f"{path}: {done.why}")
        wall, cpu = wall + done.wall, cpu + done.cpu
    return wall, cpu


def batch(quarry, arguments, work):
    return jobs.run([quarry, "batch", *arguments, "-q", "--json"], work, output=os.path.join(work, "table.json"))


def crash_when_it_runs(word, stop):
    """Sends a segmentation fault to the worker whose command line has the word."""
    while not stop.is_set():
        for entry in os.listdir("/proc"):
            try:
                if entry.isdigit() and word in open(f"/proc/{entry}/cmdline").read().split("\0"):
                    os.kill(int(entry), signal.SIGSEGV)
                    return
            except OSError:
                continue
        time.sleep(0.002)


def plant(inputs, work, size):
    """A list of all sections with three bad ones among them."""
    hang = os.path.join(work, "hang.geojson")
    os.mkfifo(hang)
    crash = os.path.join(work, "crash.geojson")
    with open(inputs[0], "rb") as source, open(crash, "wb") as copy:
        copy.write(source.read())
    entries = [f'[[job]]\ninput = "{path}"\n' for path in inputs]
    entries.insert(10, f'[[job]]\ninput = "{crash}"\nsize = {size / 10}\n')
    entries.insert(20, f'[[job]]\ninput = "{hang}"\n')
    entries.insert(30, f'[[job]]\ninput = "{inputs[1]}"\nname = "hog"\nsize = {size / 50}\n')
    path = os.path.join(work, "list.toml")
    with open(path, "w") as file:
        file.write(f"[defaults]\nsize = {size}\n" + "".join(entries))
    return path, crash


def outcomes(work):
    return {job["name"]: job for job in jobs.load_json(os.path.join(work, "table.json"))["jobs"]}


def same_meshes(inputs, a, b):
    names = [os.path.splitext(os.path.basename(path))[0] for path in inputs]
    return all(jobs.digest(os.path.join(a, name + ".geojson.vtu")) == jobs.digest(os.path.join(b, name + ".vtu"))
               for name in names)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quarry", default=str(ROOT / "build/quarry"))
    parser.add_argument("--sections", type=int, default=200)
    parser.add_argument("--lines", type=int, default=40)
    parser.add_argument("--size", type=float, default=25)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--quick", action="store_true", help="40 sections, one round")
    options = parser.parse_args()
    if options.quick:
        options.sections, options.rounds = 40, 1
    cores = os.cpu_count()
    with tempfile.TemporaryDirectory() as work:
        folder, single = os.path.join(work, "in"), os.path.join(work, "alone")
        os.makedirs(single)
        draw(options.quarry, folder, options.sections, options.lines)
        inputs = sorted(os.path.join(folder, name) for name in os.listdir(folder))
        print(f"Machine: {jobs.machine_text()}. Sources as of {jobs.source_commit()}.\n")
        print(f"{options.sections} sections of {options.lines} lines, --size {options.size:g}.\n")
        print("| round | alone: s | alone: processor s | batch: s | batch: processor s | s / (alone / cores) | "
              "processor / alone | cores busy % | threads in use % |\n|---|---|---|---|---|---|---|---|---|")
        ratios = []
        for number in range(options.rounds):
            wall, cpu = alone(options.quarry, inputs, single, options.size)
            out = os.path.join(work, f"out{number}")
            done = batch(options.quarry, [folder, "-o", out, "--size", options.size], work)
            if done.code:
                sys.exit(f"batch: {done.why}")
            ratios.append(done.wall / (wall / cores))
            in_use = sum(job["seconds"] * job["threads"] for job in outcomes(work).values())
            print(f"| {number + 1} | {wall:.1f} | {cpu:.1f} | {done.wall:.1f} | {done.cpu:.1f} | {ratios[-1]:.3f} | "
                  f"{done.cpu / cpu:.3f} | {100 * done.cpu / done.wall / cores:.0f} | "
                  f"{100 * in_use / done.wall / cores:.0f} |", flush=True)
        same = same_meshes(inputs, single, out)
        print(f"\nMedian of s / (alone / cores): {statistics.median(ratios):.3f}, wanted at most 1.1. The same bytes as "
              f"alone: {'ok' if same else 'NO'}.\n")
        again = batch(options.quarry, [folder, "-o", out, "--size", options.size], work)
        print(f"Run again, with all of it done: {again.wall:.2f} s.\n")

        path, crash = plant(inputs, work, options.size)
        stop = threading.Event()
        killer = threading.Thread(target=crash_when_it_runs, args=(crash, stop))
        killer.start()
        planted = os.path.join(work, "planted")
        done = batch(options.quarry, [path, "-o", planted, "--job-time", "5s", "--job-memory", "60MB"], work)
        stop.set()
        killer.join()
        table = outcomes(work)
        print("| planted | outcome | s | peak MB | why |\n|---|---|---|---|---|")
        ended = {name: table.pop(name) for name in PLANTED}
        for name, job in ended.items():
            print(f"| {name} | {job['outcome']} | {job['seconds']:.2f} | {job['peak_bytes'] / 1e6:.0f} | {job['message']} |")
        well = sum(job["outcome"] == "done" for job in table.values())
        harmed = not same_meshes(inputs, single, planted)
        print(f"\n{well} of the {len(table)} others done in {done.wall:.1f} s, exit code {done.code}; the same bytes as "
              f"alone: {'NO' if harmed else 'ok'}.")
        if not same or harmed or well < len(table) or {name: job["outcome"] for name, job in ended.items()} != PLANTED:
            sys.exit(1)


if __name__ == "__main__":
    main()
