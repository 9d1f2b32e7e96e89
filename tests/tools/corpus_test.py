#!/usr/bin/env python3
"""Every file of the third-party corpora loads, or is refused with one clear message and exit code 2, in bounded time.

`corpus_test.py PROGRAM FOLDER [--table]`: FOLDER has gltf_validator/ and trimesh/. --table prints the outcome of each
file. A gltf_validator file whose report has no error loads with the report's triangles.
"""

import concurrent.futures
import json
import os
import re
import subprocess
import sys

SKIPPED = 77
SECONDS = 170  # what an import may take and wait; see ImportLimits
# Files beside models, which aren't models themselves.
NO_MODELS = (".json", ".bin", ".mtl", ".md", ".jpg", ".png", ".webp", ".dart", "LICENSE")


def models_in(folder):
    for parent, _, names in sorted(os.walk(folder)):
        for name in sorted(names):
            if not name.endswith(NO_MODELS):
                yield os.path.relpath(os.path.join(parent, name), folder)


def look_into(program, folder, name):
    """The exit code, the triangles and the messages."""
    done = subprocess.run([program, "info", "--json", "--no-cache", name], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                          check=False, timeout=SECONDS)
    messages = done.stderr.decode("utf-8").splitlines()
    if done.returncode != 0:
        return done.returncode, None, messages
    info = json.loads(done.stdout)
    return 0, info["triangles"], messages + ["%s: %s" % (w["code"], w["message"]) for w in info["warnings"]]


def expected_triangles(folder, name):
    """None where the report has errors or there is none."""
    path = os.path.join(folder, name + ".report.json")
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as file:
        report = json.load(file)
    return None if report["issues"]["numErrors"] else report.get("info", {}).get("totalTriangleCount", 0)


def wrong_with(code, triangles, messages, expected):
    if code not in (0, 2):
        return "exit code %d" % code
    if code == 2 and not (len(messages) == 1 and re.search(r": error [a-z-]+: .{10}", messages[0])):
        return "not one clear message"
    if expected is not None and triangles != expected:
        return "%s triangles, %d in its report" % (triangles, expected)
    if code == 0 and triangles == 0 and not messages:
        return "no triangles and no warning"
    return None


def main():
    program, folder = os.path.abspath(sys.argv[1]), sys.argv[2]
    if not os.path.isdir(os.path.join(folder, "gltf_validator")):
        print("skipped: no models at " + folder)
        return SKIPPED
    names = [os.path.join(part, name) for part in ("gltf_validator", "trimesh")
             for name in models_in(os.path.join(folder, part))]
    failed = loaded = refused = reported = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for name, (code, triangles, messages) in zip(names, pool.map(lambda n: look_into(program, folder, n), names)):
            expected = expected_triangles(folder, name)
            wrong = wrong_with(code, triangles, messages, expected)
            loaded, refused, reported = loaded + (code == 0), refused + (code == 2), reported + (expected is not None)
            failed += wrong is not None
            if "--table" in sys.argv:
                print("%-96s %-7s %9s  %s" % (name, "loaded" if code == 0 else "refused",
                                              "" if triangles is None else triangles,
                                              "; ".join(messages).replace(name + ": ", "")))
            if wrong:
                print("FAILED %s: %s: %s" % (name, wrong, messages))
    print("%d files: %d loaded, %d refused with a message; %d have a report without errors; %d wrong"
          % (len(names), loaded, refused, reported, failed))
    return 1 if failed or reported != 129 else 0


if __name__ == "__main__":
    sys.exit(main())
