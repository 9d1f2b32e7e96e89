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
import string
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
                    script = re.sub(r'--record report|--reporter "html=[^"]*"', "", script)
                return subprocess.run(["sh", "-e", "-c", script], cwd=project, capture_output=True, text=True, check=False,
                                      env={**os.environ, "CI": "true", "CI_COMMIT_SHA": commit, "PATH": tools + ":" + os.environ["PATH"],
                                           **variables})

            def kept(job, project, **variables):
                [path] = jobs[job]["artifacts"]["paths"]
                return os.path.join(project, string.Template(path).substitute(CI_COMMIT_SHA=commit, **variables))

            for job in jobs:  # no commit can have a folder with its own hash in the name
                self.assertTrue(all("$CI_COMMIT_SHA" in path for path in jobs[job]["artifacts"]["paths"]))
            commit = "0123456789abcdef0123456789abcdef01234567"
            subprocess.run([self.program, "init", joined], check=True, capture_output=True)
            for index in range(1, jobs["walks"]["parallel"] + 1):
                project = os.path.join(folder, "machine-%d" % index)
                subprocess.run([self.program, "init", project], check=True, capture_output=True)
                done = play("walks", project, CI_NODE_INDEX=str(index), CI_NODE_TOTAL=str(jobs["walks"]["parallel"]))
                self.assertEqual(done.returncode, 0, done.stderr)
                shutil.copytree(kept("walks", project, CI_NODE_INDEX=str(index)), kept("walks", joined, CI_NODE_INDEX=str(index)))
            merged = play("verdict", joined)
            self.assertEqual((merged.returncode, merged.stderr), (0, ""), merged.stdout)
            self.assertIn("2 passed (1 by failing as expected)", merged.stdout)
            report = string.Template(jobs["verdict"]["artifacts"]["reports"]["junit"]).substitute(CI_COMMIT_SHA=commit)
            self.assertTrue(os.path.isfile(os.path.join(joined, report)))
            self.assertEqual(os.path.dirname(report), kept("verdict", ""))
            shutil.rmtree(kept("walks", joined, CI_NODE_INDEX="2"))
            self.assertEqual(play("verdict", joined).returncode, 1)

    def test_the_scripts_of_azure_run(self):
        with open(os.path.join(ROOT, "docs", "how-to", "ci.md"), encoding="utf-8") as file:
            text = re.search(r"## Azure Pipelines\n.*?```yaml\n(.*?)```", file.read(), re.DOTALL)[1]
        steps = yaml.safe_load(text)["steps"]
        install, run = (step["script"] for step in steps if "script" in step)
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            project, temporary, archived, tools = (os.path.join(folder, name) for name in ("project", "temporary", "archived", "tools"))
            subprocess.run([self.program, "init", project], check=True, capture_output=True)
            for each in (temporary, tools, os.path.join(archived, "campuswalk", "bin")):
                os.makedirs(each)
            os.symlink(self.program, os.path.join(archived, "campuswalk", "bin", "campuswalk"))
            subprocess.run(["tar", "-C", archived, "-cJf", os.path.join(folder, "package"), "campuswalk"], check=True)
            with open(os.path.join(folder, "package"), "rb") as file:
                digest = hashlib.sha256(file.read()).hexdigest()
            with open(os.path.join(tools, "curl"), "w", encoding="utf-8") as file:
                file.write('#!/bin/sh\nwhile [ "$1" != --output ]; do shift; done\ncp "%s/package" "$2"\n' % folder)
            os.chmod(os.path.join(tools, "curl"), 0o755)

            def play(script):
                """As Azure does, which goes on after a command that fails."""
                return subprocess.run(["bash", "-c", script], cwd=project, capture_output=True, text=True, check=False,
                                      env={**os.environ, "TF_BUILD": "True", "AGENT_TEMPDIRECTORY": temporary,
                                           "PATH": tools + ":" + os.environ["PATH"]})

            self.assertNotEqual(play(install.replace("HASH", "0" * 64)).returncode, 0)
            self.assertFalse(os.path.exists(os.path.join(temporary, "campuswalk")))
            done = play(install.replace("HASH", digest))
            self.assertEqual(done.returncode, 0, done.stderr)
            run = run if self.writes_html() else re.sub(r'--reporter "html=[^"]*"', "", run)
            done = play(run)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
            published = [step for step in steps if "publish" in step]
            self.assertEqual([step["publish"] for step in published], ["$(Agent.TempDirectory)/walks"])
            self.assertTrue(os.path.isfile(os.path.join(temporary, "walks", "junit.xml")))
            self.assertEqual(sorted(os.listdir(project)), sorted(self.initial_files()))

    def initial_files(self):
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            subprocess.run([self.program, "init", folder], check=True, capture_output=True)
            return os.listdir(folder)

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
            run = run if self.writes_html() else re.sub(r'--reporter "html=[^"]*"', "", run)
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
