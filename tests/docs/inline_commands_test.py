#!/usr/bin/env python3
"""The commands in running text: each names a command of the program, and options that it has; and the ten steps of
docs/how-to/your-own-campus.md run as written, on a model that `init` makes.

`inline_commands_test.py PROGRAM [SITE]`.
"""

import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

import yaml

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, "tools"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import snippets  # noqa: E402  (the path first)
from docs_site import command_lines  # noqa: E402
from docs_site.generators import Sources  # noqa: E402

FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
SPAN = re.compile(r"(?<!`)`([^`]+)`(?!`)")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]+")
# Of other programs, which the documents name.
OTHERS = {"--check", "--entrypoint", "--program"}


class InlineCommands(unittest.TestCase):
    program = ""

    @classmethod
    def setUpClass(cls):
        sources = Sources(ROOT, cls.program)
        cls.options = {name: set(OPTION.findall(sources.output(name, "--help")))
                       for name, _ in command_lines.subcommands(sources.output("--help"))}

    def spans(self):
        for page in snippets.pages(ROOT):
            with open(os.path.join(ROOT, page), encoding="utf-8") as file:
                text = FENCE.sub("", file.read())
            for span in SPAN.findall(text):
                yield page, " ".join(span.split())

    def test_commands_and_options_exist(self):
        known, count = set().union(*self.options.values(), OTHERS), 0
        for page, span in self.spans():
            command = re.match(r"campuswalk ([a-z][a-z-]*)", span)
            with self.subTest(page=page, span=span):
                if command:
                    count += 1
                    self.assertIn(command[1], self.options)
                if command or OPTION.match(span):
                    self.assertLessEqual(set(OPTION.findall(span)), self.options[command[1]] if command else known)
        print("inline: %d commands" % count)
        self.assertGreater(count, 30)

    def test_options_of_runs_in_ci_exist(self):
        """Those of Jenkins, whose file isn't run."""
        count = 0
        for page in snippets.pages(ROOT):
            with open(os.path.join(ROOT, page), encoding="utf-8") as file:
                for call in re.findall(r"^ +sh '''campuswalk run( --.*?)'''", file.read(), re.MULTILINE | re.DOTALL):
                    count += 1
                    with self.subTest(page=page, call=call):
                        self.assertLessEqual(set(OPTION.findall(call)), self.options["run"])
        self.assertGreater(count, 0)

    def test_the_shards_of_gitlab_merge(self):
        """The jobs of docs/how-to/ci.md, one machine after the other, with the artifacts of all in one folder."""
        with open(os.path.join(ROOT, "docs", "how-to", "ci.md"), encoding="utf-8") as file:
            text = re.search(r"### Shards on GitLab\n.*?```yaml\n(.*?)```", file.read(), re.DOTALL)[1]
        jobs = yaml.safe_load(text)
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            tools, joined = os.path.join(folder, "tools"), os.path.join(folder, "joined")
            os.makedirs(tools)
            os.symlink(self.program, os.path.join(tools, "campuswalk"))

            def play(job, project, **variables):
                [script] = jobs[job]["script"]
                if not self.writes_html():
                    script = script.replace("--record report", "").replace("--reporter html=out/report.html", "")
                return subprocess.run(["sh", "-e", "-c", script], cwd=project, capture_output=True, text=True, check=False,
                                      env={**os.environ, "CI": "true", "PATH": tools + ":" + os.environ["PATH"], **variables})

            subprocess.run([self.program, "init", joined], check=True, capture_output=True)
            codes = []
            for index in range(1, jobs["walks"]["parallel"] + 1):
                project = os.path.join(folder, "machine-%d" % index)
                subprocess.run([self.program, "init", project], check=True, capture_output=True)
                codes.append(play("walks", project, CI_NODE_INDEX=str(index), CI_NODE_TOTAL=str(jobs["walks"]["parallel"])).returncode)
                shutil.copytree(os.path.join(project, "out"), os.path.join(joined, "out"), dirs_exist_ok=True)
            merged = play("verdict", joined)
            self.assertEqual((merged.returncode, merged.stderr), (0, ""), merged.stdout)
            self.assertIn("2 passed (1 by failing as expected)", merged.stdout)
            self.assertTrue(os.path.isfile(os.path.join(joined, jobs["verdict"]["artifacts"]["reports"]["junit"])))
            os.remove(os.path.join(joined, "out", "shards", "2.jsonl"))
            self.assertEqual(play("verdict", joined).returncode, 1)
        self.assertEqual(set(codes), {0})

    def test_the_job_of_github_without_the_action(self):
        """Its scripts, with an archive that has only a link to the program in it."""
        with open(os.path.join(ROOT, "docs", "how-to", "ci.md"), encoding="utf-8") as file:
            text = re.search(r"### Without the action\n.*?```yaml\n(.*?)```", file.read(), re.DOTALL)[1]
        install, run, summarize = (step["run"] for step in yaml.safe_load(text)["jobs"]["walks"]["steps"] if "run" in step)
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            project, elsewhere, archived = (os.path.join(folder, name) for name in ("project", "elsewhere", "archived"))
            subprocess.run([self.program, "init", project], check=True, capture_output=True)
            name = re.search(r"tar .* -xf (\S+)", install)[1]
            tools = os.path.join(archived, name.rsplit("-linux", 1)[0] + "-linux-x86_64", "bin")
            os.makedirs(tools)
            os.makedirs(elsewhere)
            os.symlink(self.program, os.path.join(tools, "campuswalk"))
            archive = os.path.join(project, name)
            subprocess.run(["tar", "-C", archived, "-cJf", archive, "."], check=True)
            with open(archive, "rb") as file:
                digest = hashlib.sha256(file.read()).hexdigest()
            files = {key: os.path.join(folder, key) for key in ("GITHUB_PATH", "GITHUB_STEP_SUMMARY")}

            def play(script, path=""):
                return subprocess.run(["bash", "-e", "-c", script], cwd=project, capture_output=True, text=True, check=False,
                                      env={**os.environ, **files, "CI": "true", "GITHUB_WORKSPACE": project,
                                           "RUNNER_TEMP": elsewhere, "PATH": path + os.environ["PATH"]})

            self.assertNotEqual(play(install.replace("HASH", "0" * 64)).returncode, 0)
            self.assertFalse(os.path.exists(files["GITHUB_PATH"]))
            self.assertEqual(play(install.replace("HASH", digest)).returncode, 0)
            with open(files["GITHUB_PATH"], encoding="utf-8") as file:
                path = file.read().strip() + ":"
            run = run if self.writes_html() else run.replace("--reporter html=out/report.html", "")
            done = play(run, path)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
            self.assertEqual(play(summarize).returncode, 0)
            with open(files["GITHUB_STEP_SUMMARY"], encoding="utf-8") as file:
                self.assertIn("walks/visit.walk.yaml", file.read())

    def writes_html(self):
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            subprocess.run([self.program, "init", folder], check=True, capture_output=True)
            done = subprocess.run([self.program, "run", "-q", "--rendering-backend", "none", "--reporter", "html=a.html"], cwd=folder,
                                  capture_output=True, text=True, check=False)
        return "not-built" not in done.stderr

    def test_the_ten_steps_run_as_written(self):
        with open(os.path.join(ROOT, "docs", "how-to", "your-own-campus.md"), encoding="utf-8") as file:
            section = re.search(r"## Ten steps.*?\n(.*?)\n\n[A-Z]", file.read(), re.DOTALL)[1]
        self.assertEqual(re.findall(r"^(\d+)\. ", section, re.MULTILINE), [str(i) for i in range(1, 11)])
        commands = re.findall(r"`campuswalk ([^`]+)`", section)
        self.assertEqual([command.split()[0] for command in commands], ["info", "info", "run", "snapshot", "validate", "run"])
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            example = os.path.join(folder, "example")
            subprocess.run([self.program, "init", example], check=True, capture_output=True)
            for name in ("school.obj", "school.mtl"):
                shutil.copy(os.path.join(example, name), folder)
            for command in commands:
                with self.subTest(command=command):
                    done = subprocess.run([self.program, *shlex.split(command.replace("school.glb", "school.obj"))], cwd=folder,
                                          capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    InlineCommands.program = os.path.abspath(sys.argv[1])
    unittest.main(argv=[sys.argv[0]])
