"""The processes behind bench/quads.py: jobs of the command, programs that print rows, and independent checks."""
import json
import os

from jobs import Referee, call_checker, load_json, python_with_numpy, run, say
from maps import OUTLINES, box_of

HERE = os.path.dirname(os.path.abspath(__file__))
# A mesh edge lies on a line within this share of the element size; cleaned lines come no nearer to each other than 5 %.
NEAR = 0.01


class QuadJobs:
    def __init__(self, arguments, folder):
        self.quarry, self.programs, self.folder = arguments.quarry, arguments.programs, folder
        self.planar = os.path.join(arguments.data, "planar")
        self.network = arguments.network
        self.quick = arguments.quick
        self.repeat = 1 if arguments.quick else arguments.repeat
        self.referee = Referee(arguments.referee)
        self.python = python_with_numpy()

    def path(self, *parts):
        return os.path.join(self.folder, "_".join(map(str, parts)))

    def lines(self, name):
        """The lines of a map, or None where it is not at hand."""
        path = os.path.join(self.planar, f"{name}.lines.geojson")
        return path if os.path.exists(path) else None

    def boundary(self, name):
        return ["--boundary", self.lines(OUTLINES[name])] if name in OUTLINES else []

    def size(self, name, division):
        x0, y0, x1, y1 = box_of(self.lines(name))
        return max(x1 - x0, y1 - y0) / division

    def rows(self, program, *arguments, limit=1200):
        """The lines of JSON that a benchmark prints."""
        printed = self.path(program + ".txt")
        done = run([os.path.join(self.programs, program), *map(str, arguments)], self.folder, limit, printed)
        if done.code != 0:
            raise SystemExit(f"{program}: {done.why}")
        say(f"{program} {' '.join(map(str, arguments))}: {done.wall:.1f} s")
        with open(printed) as file:
            return [json.loads(line) for line in file]

    def mesh(self, lines, out, size, extra=(), threads=1):
        """One job -> (run, report); the report is None if it failed."""
        report = out + ".json"
        done = run([self.quarry, "mesh", lines, "--size", f"{size:.12g}", "-o", out, "--report", report, "--threads",
                    str(threads), "--quiet", *extra], self.folder)
        say(f"{os.path.basename(out)}: {done.wall:.1f} s" + ("" if done.code == 0 else f", {done.why}"))
        return done, load_json(report) if done.code == 0 else None

    def mesh_at_count(self, lines, out, size, count):
        """The job with about so many quads: the size is corrected until they are within 2 %."""
        for _ in range(4):
            done, report = self.mesh(lines, out, size)
            if report is None or abs(report["counts"]["quads"] / count - 1) < 0.02:
                break
            size *= (report["counts"]["quads"] / count) ** 0.5
        return done, report

    def clean(self, lines, out, size, extra=()):
        done = run([self.quarry, "clean", lines, *extra, "--size", f"{size:.12g}", "-o", out, "--quiet"], self.folder)
        if done.code != 0:
            raise SystemExit(f"quarry clean {lines}: {done.why}")

    def quality(self, mesh):
        """The command's figures; {"failed": [why]} where it refuses the mesh."""
        printed = self.path("quality.json")
        done = run([self.quarry, "quality", mesh, "--json"], self.folder, output=printed)
        return load_json(printed) if done.code == 0 else {"failed": [done.why]}

    def check(self, script, *arguments):
        return call_checker(self.python, os.path.join(HERE, script), *arguments) if self.python else None

    def against_lines(self, mesh, clean, size, shift=(0, 0)):
        """How much of the cleaned lines a mesh kept, and its poor faces."""
        common = [mesh, clean, "--near", repr(NEAR * size), "--shift", *map(repr, shift)]
        return {"kept": self.check("kept_lines.py", *common), "poor": self.check("poor_faces.py", *common)}

    def agreement(self, mesh, quality):
        """The largest difference between the command's figures and the referee's; None where it is not at hand."""
        if not self.referee.there:
            return None
        other = self.referee.quality(mesh)
        quad = other["quad"]
        return max(abs(quality["scaled_jacobian"]["min"] - quad["scaled_jacobian"]["min"]),
                   abs(quality["scaled_jacobian"]["mean"] - quad["scaled_jacobian"]["mean"]),
                   abs(quality["aspect"]["max"] - quad["aspect_max_over_min_edge"]["max"]),
                   # The referee rounds this one to three digits.
                   abs(round(100 * quality["valence"]["irregular_share"], 3) - other["valence"]["irregular_pct"]))
