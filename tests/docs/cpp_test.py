#!/usr/bin/env python3
"""The programs of docs/cpp/index.md build against the installed library, as the page's CMakeLists.txt says, and run.

`cpp_test.py PROGRAM [SITE] [--installed PREFIX]`: the library is installed from the program's build tree, or was to PREFIX.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PAGE = os.path.join(ROOT, "docs", "cpp", "index.md")


def run(*command, folder=None):
    """What it prints; fails with that if it fails."""
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit("%s\nexited with %d:\n%s" % (" ".join(command), done.returncode, done.stdout))
    return done.stdout


def main():
    """Builds and runs the programs; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("site", nargs="?")
    parser.add_argument("--installed")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    build = os.path.dirname(program)
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    walks, trees = re.findall(r"^```cpp\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    cmake = re.search(r"^```cmake\n(.*?)^```", page, re.MULTILINE | re.DOTALL)[1]
    with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
        prefix = options.installed
        if not prefix:
            if not os.path.exists(os.path.join(build, "cmake_install.cmake")):
                print("cpp: skipped, there is no build tree beside %s" % options.program)
                return 0
            prefix = os.path.join(folder, "installed")
            for component in ("collision", "engine"):
                run("cmake", "--install", build, "--component", component, "--prefix", prefix)
        files = {"example.cpp": walks, "trees.cpp": trees,
                 "CMakeLists.txt": cmake + "add_executable(trees trees.cpp)\ntarget_link_libraries(trees PRIVATE campuswalk::collision)\n"}
        for name, text in files.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        built = os.path.join(folder, "built")
        run("cmake", "-S", folder, "-B", built, "-DCMAKE_PREFIX_PATH=" + os.path.abspath(prefix), "-DCMAKE_BUILD_TYPE=Release")
        run("cmake", "--build", built)
        run(program, "init", os.path.join(folder, "school"))
        printed = run(os.path.join(built, "school_walks"), folder=os.path.join(folder, "school"))
        if not printed.splitlines()[-1].startswith("visited: yes, stopped by the wall: yes, 25.5 m"):
            raise SystemExit("docs/cpp/index.md's first program prints:\n" + printed)
        log = run(program, "run", "walks/visit.walk.yaml", folder=os.path.join(folder, "school"))
        if printed.splitlines()[:-1] != [line for line in log.splitlines() if not line.startswith("visit: ")]:
            raise SystemExit("its log isn't that of campuswalk run:\n" + printed)
        printed = run(os.path.join(built, "trees"))
        if printed != ("ground 0 overlaps sail 0\nground 1 overlaps sail 0\na ray down hits ground 1 at 0.8 of its length\n"):
            raise SystemExit("docs/cpp/index.md's second program prints:\n" + printed)
    print("cpp: both programs build against the installed library, and print what they should")
    return 0


if __name__ == "__main__":
    sys.exit(main())
