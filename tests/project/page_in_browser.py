#!/usr/bin/env python3
"""Opens a page of quarry in headless Chromium and looks whether the mesh is drawn.

usage: page_in_browser.py QUARRY       exits with 0 if it is, or, with a word about it, if there is no Chromium
"""

import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

WIDTH, HEIGHT, SIDE = 1200, 800, 330  # pixels; of the column of figures
DATA = Path(__file__).resolve().parent.parent / "data"


def pixels_of(png):
    """Rows of bytes, and how many of them a pixel has: colour types 2 and 6 with 8 bits, not interlaced."""
    at, packed, header = 8, b"", None
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        at += 12 + size
        header = struct.unpack(">IIBB", body[:10]) if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
    width, height, _, colour = header
    step = {2: 3, 6: 4}[colour]
    raw, rows, before = zlib.decompress(packed), [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        method, row = raw[start], bytearray(raw[start + 1:start + 1 + width * step])
        for i in range(len(row)):
            left = row[i - step] if i >= step else 0
            up, corner = before[i], before[i - step] if i >= step else 0
            guess = left + up - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[method]) % 256
        rows.append(row)
        before = row
    return rows, step


def main():
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if browser is None:
        print("page_in_browser: skipped, there is no Chromium")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        page, picture = Path(folder) / "page.html", Path(folder) / "page.png"
        subprocess.run([sys.argv[1], "mesh", DATA / "demo_horizon.obj", "--lines", DATA / "demo_horizon_traces.geojson",
                        "--size", "30", "-o", Path(folder) / "mesh.vtu", "--page", page, "--quiet"], check=True)
        subprocess.run([browser, "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                        "--hide-scrollbars", f"--window-size={WIDTH},{HEIGHT}", "--virtual-time-budget=5000",
                        f"--user-data-dir={folder}/profile", f"--screenshot={picture}", page.as_uri()],
                       check=True, capture_output=True, timeout=120)
        rows, step = pixels_of(picture.read_bytes())
    drawn = [bytes(row[x * step:x * step + 3]) for row in rows[::4] for x in range(SIDE, len(row) // step, 4)]
    coloured = sum(1 for r, g, b in drawn if max(r, g, b) - min(r, g, b) > 8)
    share, shades = coloured / len(drawn), len(set(drawn))
    print(f"page_in_browser: {100 * share:.0f} % of the view has colour, {shades} shades")
    return 0 if share > 0.1 and shades > 200 else 1


if __name__ == "__main__":
    sys.exit(main())
