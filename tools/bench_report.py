#!/usr/bin/env python3
"""Measures what HTML reports cost, and exits with 1 if it is more than they may: tools/bench report.

A thousand walks of a quarter of a minute with and without a report, by turns; the demo tour's report; a campus of a
million triangles. Needs only the standard library.
"""

import argparse
import math
import os
import random
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
WALKS = 1000
ROUNDS = 15
MEGABYTE = 1_000_000


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def run(program, folder, *arguments):
    """Wall and processor seconds."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run([program, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (time.monotonic() - start, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)


def write_walks(folder):
    dice = random.Random(1)
    campus = os.path.relpath(os.path.join(ROOT, "config", "demo.campus.yaml"), os.path.join(folder, "walks"))
    for i in range(WALKS):
        x, z = dice.uniform(-20, 20), dice.uniform(30, 70)
        write(os.path.join(folder, "walks", f"w{i:04}.walk.yaml"), f"""\
campus: {campus}
steps:
  - spawn: main-gate
  - walk_to: {{to: [{x / 8:.2f}, {z:.2f}], if_blocked: continue, timeout: 8}}
  - walk_to: {{to: [{x:.2f}, {z - 10:.2f}], if_blocked: continue, timeout: 6}}
  - turn: {dice.uniform(0, 360):.0f}
expect:
  - never: "avatar.fell *"
""")


def measure_walks(program, folder):
    """Shares of wall and of processor time that a report adds: medians of rounds without, with, with, without, so that
    neither a machine that gets slower or faster nor one that is busy for a while favours one of them. In memory, where there
    is such a folder: ext4 passes one by one over the inodes of files that were deleted in the last five minutes, which took up
    to 0.3 s of processor time for a thousand recordings, so that it measured what had run before."""
    write_walks(folder)

    def play(*arguments):
        with tempfile.TemporaryDirectory(dir=folder) as output:
            return run(program, folder, "run", "walks", "--root", ROOT, "--rendering-backend", "none", "-q", "--output", output,
                       *arguments)

    html = ("--reporter", "html=r.html")
    play(*html)  # fills the cache
    added = []
    for _ in range(ROUNDS):
        before, first, second, after = play(), play(*html), play(*html), play()
        added.append([(first[k] + second[k]) / (before[k] + after[k]) - 1 for k in (0, 1)])
    run(program, folder, "run", "walks/w0000.walk.yaml", "--root", ROOT, "--rendering-backend", "none", "-q", "--output", "one",
        "--reporter", "html=one.html")
    wall, processor = (statistics.median(each[k] for each in added) for k in (0, 1))
    bytes_added = os.path.getsize(os.path.join(folder, "r.html")) - os.path.getsize(os.path.join(folder, "one.html"))
    return wall, processor, bytes_added


def write_million_triangles(folder):
    """Hills with houses on them."""
    dice, lines, count = random.Random(2), [], 0
    cells = 500

    def height(x, z):
        return 4 * math.sin(x / 40) + 3 * math.cos(z / 55) + 0.1 * math.sin(x * 1.7) * math.cos(z * 1.3)

    lines.append("o ground")
    for i in range(cells + 1):
        lines += [f"v {i - 250} {height(i, j):.4f} {j - 250}" for j in range(cells + 1)]
    for i in range(cells):
        for j in range(cells):
            a = i * (cells + 1) + j + 1
            lines += [f"f {a} {a + 1} {a + cells + 2}", f"f {a} {a + cells + 2} {a + cells + 1}"]
            count += 2
    vertices = (cells + 1) ** 2
    faces = ((1, 2, 3), (1, 3, 4), (5, 7, 6), (5, 8, 7), (1, 5, 6), (1, 6, 2), (2, 6, 7), (2, 7, 3), (3, 7, 8), (3, 8, 4), (4, 8, 5),
             (4, 5, 1))
    for house in range(100):
        lines.append(f"o house-{house}")
        x, z = dice.uniform(-230, 220), dice.uniform(-230, 220)
        for _ in range(420):
            cx, cy, cz = x + dice.uniform(0, 12), dice.uniform(4, 16), z + dice.uniform(0, 12)
            sx, sy, sz = (dice.uniform(0.1, 1.5) for _ in range(3))
            for dy in (-sy, sy):
                lines += [f"v {cx + a * sx:.4f} {cy + dy:.4f} {cz + b * sz:.4f}" for a, b in ((-1, -1), (-1, 1), (1, 1), (1, -1))]
            lines += ["f " + " ".join(str(vertices + k) for k in face) for face in faces]
            vertices += 8
            count += 12
    write(os.path.join(folder, "million.obj"), "\n".join(lines) + "\n")
    write(os.path.join(folder, "million.campus.yaml"), """\
scenes: [{file: million.obj}]
colliders: [{id: ground, nodes: ground, shape: mesh, mode: solid}]
spawns: {start: {at: [0, 12, 0]}}
""")
    write(os.path.join(folder, "million.walk.yaml"), "campus: million.campus.yaml\nsteps: [{spawn: start}, {wait: 1}]\n")
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/campuswalk")
    program = os.path.abspath(parser.parse_args().program)
    within = []

    def judge(name, value, most, unit):
        within.append(value <= most)
        print(f"{name:<52} {value:8.2f} {unit:<2} of at most {most:g} {unit}{'' if within[-1] else '  TOO MUCH'}", flush=True)

    memory = "/dev/shm" if os.path.isdir("/dev/shm") else None
    with tempfile.TemporaryDirectory(prefix="campuswalk-report-", dir=memory) as folder:
        wall, processor, added = measure_walks(program, folder)
        judge(f"{WALKS} walks of 15 s: added to the run's time", 100 * wall, 10, "%")
        print(f"{'  added to its processor time':<52} {100 * processor:8.2f} %")
        judge(f"{WALKS} walks of 15 s: added to the file", added / MEGABYTE, 3, "MB")
        run(program, ROOT, "run", "config/walks/first-tour.walk.yaml", "-q", "--output", os.path.join(folder, "tour"), "--reporter",
            "html=" + os.path.join(folder, "tour.html"))
        judge("the demo tour's report", os.path.getsize(os.path.join(folder, "tour.html")) / MEGABYTE, 5, "MB")
        count = write_million_triangles(folder)
        run(program, folder, "run", "million.walk.yaml", "--rendering-backend", "none", "-q", "--reporter", "html=million.html")
        judge(f"a campus of {count} triangles", os.path.getsize(os.path.join(folder, "million.html")) / MEGABYTE, 25, "MB")
    sys.exit(0 if all(within) else 1)


if __name__ == "__main__":
    main()
