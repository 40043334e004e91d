"""Runs whole processes and says what they took: the ground that bench/maps.py and bench/quads.py stand on.

On Linux the peak memory of a process starts at what its parent held when it was started. So jobs are started by a
shell, which is small, and what needs numpy (the checkers) runs as a process of its own.
"""
import dataclasses
import hashlib
import json
import os
import platform
import shutil
import signal
import statistics
import subprocess
import sys
import time


@dataclasses.dataclass
class Run:
    code: int        # exit code; -1: it ran past its limit
    wall: float      # seconds
    cpu: float       # seconds of user and system, all threads together
    peak: int        # bytes; no less than this interpreter's own
    errors: str      # what it wrote to stderr

    @property
    def why(self):
        lines = [line for line in self.errors.strip().splitlines() if line]
        return f"exit {self.code}: {lines[-1][:160] if lines else 'no message'}"


def say(text):
    print(time.strftime("%H:%M:%S"), text, file=sys.stderr, flush=True)


def run(command, folder, limit=1200, output=os.devnull):
    """Runs one process to its end. User + system time and peak memory are the kernel's (wait4). `output`: a file for
    what it prints."""
    through_shell = ["/bin/sh", "-c", '"$@"; exit $?', "sh", *map(str, command)]
    log = os.path.join(folder, "stderr.txt")
    with open(log, "wb") as errors, open(output, "wb") as printed:
        start = time.perf_counter()
        child = subprocess.Popen(through_shell, stdout=printed, stderr=errors, start_new_session=True)
        while True:
            # A waiting loop instead of a blocking wait gives the limit; 2 ms of grain against seconds of work.
            pid, status, usage = os.wait4(child.pid, os.WNOHANG)
            if pid:
                break
            if time.perf_counter() - start > limit:
                os.killpg(child.pid, signal.SIGKILL)
                _, status, usage = os.wait4(child.pid, 0)
                status = None
                break
            time.sleep(0.002)
        wall = time.perf_counter() - start
    child.returncode = -1 if status is None else os.waitstatus_to_exitcode(status)
    with open(log, errors="replace") as errors:
        text = errors.read()[-4000:].replace(os.path.join(folder, ""), "")
    return Run(child.returncode, wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, text)


def median_run(runs):
    """The run whose figures are the medians of several: each figure for itself."""
    return Run(max(r.code for r in runs), statistics.median(r.wall for r in runs),
               statistics.median(r.cpu for r in runs), max(r.peak for r in runs), runs[-1].errors)


def digest(path):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest() if hasattr(hashlib, "file_digest") else \
            hashlib.sha256(file.read()).hexdigest()


def chosen(parser, text, allowed, kind):
    """The names in a comma-separated --only; ends the program where one is unknown."""
    names = [name for name in text.split(",") if name]
    unknown = set(names) - set(allowed)
    if unknown:
        parser.error(f"--only {','.join(sorted(unknown))}: {kind} are {', '.join(allowed)}")
    return names


def load_json(path):
    with open(path) as file:
        return json.load(file)


class Referee:
    """Independent checks of a mesh file, where they are at hand; they need numpy and scipy."""

    def __init__(self, folder):
        self.folder = folder
        self.python = python_with_numpy()

    @property
    def there(self):
        return self.python is not None and os.path.exists(os.path.join(self.folder, "section.py"))

    def call(self, script, *arguments):
        return call_checker(self.python, os.path.join(self.folder, script), *arguments)

    def section(self, mesh, lines, report, all_quad=True):
        options = load_json(report)["options"]
        near = options["snap"] + options["min-edge"] + options["tolerance"]
        # Aspect is bounded for quads alone: a triangle in a narrow wedge is as long as the wedge is narrow.
        extra = ["--all-quad", "--max-aspect", 12] if all_quad else []
        return self.call("section.py", mesh, "--lines", lines, "--near", repr(near), "--report", report, *extra)

    def quality(self, mesh):
        return self.call("planar_quality.py", mesh)


def call_checker(python, script, *arguments):
    """What a script prints as JSON; {"failed": why} if it does not."""
    done = subprocess.run([python, script, *map(str, arguments)], capture_output=True, text=True)
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError:
        return {"failed": [f"{os.path.basename(script)} ended with {done.returncode}: {done.stderr.strip()[-200:]}"]}


def python_with_numpy():
    return next((p for p in (sys.executable, "/usr/bin/python3") if p and has_numpy(p)), None)


def has_numpy(python):
    check = subprocess.run([python, "-c", "import numpy, scipy"], capture_output=True)
    return check.returncode == 0


def first_line(command):
    if not shutil.which(command[0]):
        return ""
    done = subprocess.run(command, capture_output=True, text=True)
    return next(iter((done.stdout or done.stderr).strip().splitlines()), "")


def source_commit():
    """The last commit that changed what is measured; "" outside a checkout."""
    return first_line(["git", "log", "-1", "--format=%h", "--", "engine", "kernels", "surface", "io", "pipeline"])


def machine_text():
    """The machine in general words: cores, memory, system, compiler."""
    memory = 0
    with open("/proc/meminfo") as file:
        for line in file:
            if line.startswith("MemTotal"):
                memory = round(int(line.split()[1]) / 2**20)
    system = platform.system()
    if os.path.exists("/etc/os-release"):
        with open("/etc/os-release") as file:
            names = dict(line.strip().split("=", 1) for line in file if "=" in line)
        system = names.get("PRETTY_NAME", system).strip('"')
    return f"{os.cpu_count()} cores, {memory} GB, {system}, {first_line(['g++', '--version'])}, -O3"
