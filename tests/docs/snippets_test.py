#!/usr/bin/env python3
"""Runs every snippet of README.md and docs/: see snippets.py for what they may be. Each page has a scratch folder.

`snippets_test.py PROGRAM [SITE] [--only PAGE]`. Needs g++ and Eigen for snippets in C++.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

import yaml

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import snippets  # noqa: E402  (the path first)

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
VALIDATED = (".walk.yaml", ".campus.yaml", ".avatar.yaml", ".light.yaml", ".steps.yaml")
NOT_RUN = {"text", "ini", "cmake", "groovy"}
# What changes which walks run, or what they may write.
STEERING = ("CI", "CAMPUSWALK_SHARD_INDEX", "CAMPUSWALK_SHARD_COUNT", "TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS",
            "SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX", "CAMPUSWALK_RUN_KEY", "GITHUB_STEP_SUMMARY")


class Fault(Exception):
    """A snippet that doesn't do what the page says."""


class PageRun:
    """One page in its scratch folder."""

    def __init__(self, page, program, scratch):
        self.page, self.program, self.scratch = page, program, scratch
        self.folder, self.code, self.base = os.path.join(scratch, "page"), 0, None
        tools = os.path.join(scratch, "tools")
        os.makedirs(tools)
        os.makedirs(self.folder)
        os.symlink(program, os.path.join(tools, "campuswalk"))
        self.variables = {name: value for name, value in os.environ.items() if name not in STEERING}
        self.variables.update(PATH=tools + ":" + os.environ["PATH"], CAMPUSWALK=ROOT, LC_ALL="C.UTF-8")
        self.counts, self.skipped = {}, []

    def shell(self, command):
        """Runs it where the one before ended; what it prints, and its code in self.code."""
        where = os.path.join(self.scratch, "where")
        script = "%s\ncode=$?\npwd > %s\nexit $code\n" % (command, where)
        # By lines, as on a terminal: what goes to standard error comes where the reader sees it.
        done = subprocess.run(["stdbuf", "-oL", "bash", "-c", script], cwd=self.folder, env=self.variables, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True, timeout=600, check=False)
        self.code = done.returncode
        if os.path.exists(where):
            with open(where, encoding="utf-8") as file:
                self.folder = file.read().strip()
        return done.stdout

    def must_succeed(self, command):
        printed = self.shell(command)
        if self.code != 0:
            raise Fault("exit code %d of: %s\n%s" % (self.code, command, printed))
        return printed

    def console(self, text):
        entries = snippets.commands(text)
        for i, (command, expected) in enumerate(entries):
            if command == "echo $?":
                if [str(self.code)] != expected:
                    raise Fault("the exit code is %d, not %s" % (self.code, "".join(expected)))
                self.code = 0
                continue
            printed = self.shell(command)
            code_follows = i + 1 < len(entries) and entries[i + 1][0] == "echo $?"
            if self.code != 0 and not code_follows:
                raise Fault("exit code %d of: %s\n%s" % (self.code, command, printed))
            if not snippets.matches(printed, expected):
                raise Fault("%s\nprints:\n%s\nnot:\n%s" % (command, printed, "\n".join(expected)))

    def path(self, name):
        return os.path.join(self.folder, name)

    def validate(self, name):
        self.must_succeed("campuswalk validate '%s'" % name)

    def yaml(self, snippet):
        name = snippets.named_file(snippet.text)
        same = next((each.argument for each in snippet.directives if each.kind == "same"), None)
        keys = yaml.safe_load(snippet.text)
        if same:
            with open(self.path(same), encoding="utf-8") as file:
                if yaml.safe_load(file) != keys:
                    raise Fault("it isn't what %s says" % same)
        elif name:
            os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write(snippet.text)
            if name.endswith(VALIDATED):
                self.validate(name)
            elif os.path.basename(name) == "walks.config.yaml":
                self.must_succeed("campuswalk run --list --config '%s'" % name)
        elif self.base is None:
            raise Fault("a fragment of YAML needs <!-- test: base FILE -->")
        else:
            self.fragment(keys)

    def fragment(self, keys):
        with open(self.path(self.base), encoding="utf-8") as file:
            whole = yaml.safe_load(file)
        unknown = set(keys) - {"campus", "avatar", "sim", "status", "tags", "timeout", "camera", "light", "steps", "expect",
                               "scenes", "origin", "layers", "buildings", "colliders", "spawns", "places"}
        if unknown:
            raise Fault("unknown keys: %s" % ", ".join(sorted(unknown)))
        if "steps" in keys and "spawn" not in keys["steps"][0]:
            keys["steps"] = [whole["steps"][0], *keys["steps"]]
        for key in ("buildings", "colliders"):  # what replaces one with the same id, or comes last
            if key in keys and key in whole:
                ids = {each["id"] for each in keys[key]}
                keys[key] = [each for each in whole[key] if each["id"] not in ids] + keys[key]
        folder, name = os.path.split(self.base)
        trial = os.path.join(folder, "fragment" + name[name.index("."):])
        with open(self.path(trial), "w", encoding="utf-8") as file:
            yaml.safe_dump({**whole, **keys}, file, allow_unicode=True)
        self.validate(trial)
        os.remove(self.path(trial))

    def compile(self, text):
        """A whole program is compiled against the headers of the checkout; false if nothing here can."""
        if not shutil.which("g++") or not os.path.isdir("/usr/include/eigen3"):
            return False
        with open(self.path("example.cpp"), "w", encoding="utf-8") as file:
            file.write(text)
        self.must_succeed("g++ -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I'%s' -isystem /usr/include/eigen3 example.cpp" % ROOT)
        return True

    def excerpt(self, text, name):
        with open(os.path.join(ROOT, name), encoding="utf-8") as file:
            if not snippets.matches(file.read(), text.splitlines()):
                raise Fault("it isn't from " + name)

    def picture(self, picture):
        kept = os.path.normpath(os.path.join(ROOT, os.path.dirname(self.page), picture.target))
        printed = self.shell("campuswalk imgdiff '%s' '%s'" % (kept, picture.expected))
        if self.code != 0:
            raise Fault("%s isn't %s any more; copy it anew:\n%s" % (picture.target, picture.expected, printed))

    def run(self, part):
        if isinstance(part, snippets.Directive):
            if part.kind == "base":
                self.base = part.argument
            else:
                self.must_succeed(part.argument)
            return
        if isinstance(part, snippets.Picture):
            self.picture(part)
            self.count("picture")
            return
        skip, excerpt = (next((each for each in part.directives if each.kind == kind), None) for kind in ("skip", "excerpt"))
        if excerpt:
            self.excerpt(part.text, excerpt.argument)
        elif skip:
            if part.language == "yaml":
                yaml.safe_load(part.text)
            self.skipped.append((part.line, skip.argument))
        elif part.language == "console":
            self.console(part.text)
        elif part.language == "sh":
            self.must_succeed("set -e\n" + part.text)
        elif part.language == "yaml":
            self.yaml(part)
        elif part.language == "cpp":
            if not self.compile(part.text):
                self.skipped.append((part.line, "g++ and Eigen aren't here"))
        elif part.language == "json":
            for line in part.text.splitlines():
                json.loads(line)
        elif part.language not in NOT_RUN:
            raise Fault("nobody knows how to run '%s'" % part.language)
        self.count("skipped" if skip else "excerpt" if excerpt else part.language)

    def count(self, what):
        self.counts[what] = self.counts.get(what, 0) + 1


def run_page(page, program):
    """Runs a page's snippets in order; the faults, the counts and what was skipped."""
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        parts = snippets.read(file.read())
    scratch = tempfile.mkdtemp(prefix="campuswalk-docs-")
    run = PageRun(page, program, scratch)
    faults = []
    try:
        for part in parts:
            try:
                run.run(part)
            except (Fault, ValueError, OSError, KeyError, yaml.YAMLError, subprocess.TimeoutExpired) as error:
                faults.append("%s:%d: %s" % (page, part.line, error))
                break  # what follows may need it
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    return faults, run.counts, run.skipped


def main():
    """Runs all pages and returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("site", nargs="?", help="not used: tools/docs-site hands it to all tests")
    parser.add_argument("--only", help="one page, such as docs/tutorial.md")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    total, faulty = {}, []
    for page in [options.only] if options.only else snippets.pages(ROOT):
        start = time.monotonic()
        faults, counts, skipped = run_page(page, program)
        for what, number in counts.items():
            total[what] = total.get(what, 0) + number
        words = ", ".join("%d %s" % (number, what) for what, number in sorted(counts.items())) or "no snippets"
        print("%-42s %5.1f s  %s%s" % (page, time.monotonic() - start, words, "  FAULTY" if faults else ""), flush=True)
        for line, reason in skipped:
            print("    line %d isn't run: %s" % (line, reason))
        faulty += faults
    print("snippets: %s" % ", ".join("%d %s" % (number, what) for what, number in sorted(total.items())))
    for fault in faulty:
        print("\n" + fault)
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
