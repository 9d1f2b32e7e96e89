#!/usr/bin/env python3
"""action.yml's steps, run as GitHub's runner runs them, with actions of others in name only."""

import filecmp
import glob
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tarfile

import yaml

from poisoned_cache import PoisonedCache, narrow_the_door
from program import ProgramCase, main

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Runner:
    """A job on a machine of its own: the steps of a composite action, one after the other."""

    def __init__(self, folder, action_repository=""):
        self.folder = folder
        self.action_repository = action_repository
        self.workspace = os.path.join(folder, "workspace")
        self.temp = os.path.join(folder, "temp")
        os.makedirs(self.temp, exist_ok=True)
        os.makedirs(self.workspace, exist_ok=True)
        with open(os.path.join(ROOT, "action.yml"), encoding="utf-8") as file:
            self.action = yaml.safe_load(file)
        self.path = os.environ["PATH"]
        self.output = ""
        self.summary = ""
        self.uploads = {}

    def evaluate(self, expression, inputs, failed=False):
        """The expressions that action.yml uses."""
        def value(match):
            name = match[0]
            if name == "always()":
                return "True"
            if name.startswith("inputs."):
                return repr(inputs[name[len("inputs."):]])
            if name.startswith("steps."):
                _, step, _, output = name.split(".")
                return repr(self.outputs.get(step, {}).get(output, ""))
            if name == "github.action_repository":
                return repr(self.action_repository)
            if name.startswith("hashFiles("):
                return "'hash'"
            return name
        python = re.sub(r"hashFiles\([^)]*\)|always\(\)|[a-z]+\.[a-z0-9_.-]+|'[^']*'", value, expression)
        python = python.replace("&&", " and ").replace("||", " or ")
        if failed and "always()" not in expression:
            return False
        return eval(python, {"__builtins__": {}})  # pylint: disable=eval-used

    def filled(self, text, inputs):
        return re.sub(r"\$\{\{\s*(.*?)\s*\}\}", lambda match: str(self.evaluate(match[1], inputs)), str(text))

    def run(self, **given):
        """Returns the exit code of the first step that failed, or 0."""
        inputs = {name: each.get("default", "") for name, each in self.action["inputs"].items()}
        unknown = set(name.replace("_", "-") for name in given) - set(inputs)
        assert not unknown, unknown
        inputs.update({name.replace("_", "-"): text for name, text in given.items()})
        self.outputs = {}
        failed = 0
        for number, step in enumerate(self.action["runs"]["steps"]):
            if not self.evaluate(step.get("if", "True"), inputs, failed != 0):
                continue
            if failed and "if" not in step:
                continue
            if "uses" in step:
                self.use(step, inputs)
            else:
                failed = self.shell(step, inputs, number) or failed
        return failed

    def use(self, step, inputs):
        settings = {name: self.filled(text, inputs) for name, text in step["with"].items()}
        if "upload-artifact" in step["uses"]:
            self.uploads[settings["name"]] = settings["path"]
            self.outputs[step["id"]] = {"artifact-url": "https://github.example/artifacts/7"}
        else:
            assert "actions/cache" in step["uses"]
            self.cache = settings

    def shell(self, step, inputs, number):
        assert step["shell"] == "bash"
        files = {name: os.path.join(self.temp, f"{name}-{number}") for name in ("GITHUB_OUTPUT", "GITHUB_PATH",
                                                                             "GITHUB_ENV", "GITHUB_STEP_SUMMARY")}
        for name in files.values():
            open(name, "w", encoding="utf-8").close()
        script = os.path.join(self.temp, f"script-{number}.sh")
        with open(script, "w", encoding="utf-8") as file:
            file.write(self.filled(step["run"], inputs))
        done = subprocess.run(
            ["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", script],
            cwd=os.path.join(self.workspace, self.filled(step.get("working-directory", "."), inputs)),
            env={**os.environ, **files, **{name: self.filled(text, inputs) for name, text in step.get("env", {}).items()},
                 "PATH": self.path, "CI": "true", "GITHUB_ACTIONS": "true", "GITHUB_ACTION_PATH": ROOT,
                 "GITHUB_WORKSPACE": self.workspace, "RUNNER_TEMP": self.temp},
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300, check=False)
        self.output += done.stdout.decode()
        with open(files["GITHUB_OUTPUT"], encoding="utf-8") as file:
            self.outputs[step.get("id", str(number))] = dict(line.rstrip("\n").split("=", 1) for line in file)
        with open(files["GITHUB_PATH"], encoding="utf-8") as file:
            for line in file:
                self.path = line.strip() + ":" + self.path
        with open(files["GITHUB_STEP_SUMMARY"], encoding="utf-8") as file:
            self.summary += file.read()
        return done.returncode


class Action(ProgramCase):
    with_html = False

    def setUp(self):
        super().setUp()
        self.package = self.path("campuswalk-9.9.9-linux-x86_64.tar.xz")
        self.write("package/campuswalk-9.9.9/bin/campuswalk", '#!/bin/sh\nexec "%s" "$@"\n' % self.program)
        os.chmod(self.path("package/campuswalk-9.9.9/bin/campuswalk"), 0o755)
        with tarfile.open(self.package, "w:xz") as archive:
            archive.add(self.path("package/campuswalk-9.9.9"), "campuswalk-9.9.9")

    def runner(self, name="job", **options):
        runner = Runner(self.path(name), **options)
        self.passes("init", "--template", "stairs", runner.workspace + "/campus")
        os.makedirs(runner.workspace + "/.git")
        runner.before = self.checkout(runner)
        return runner

    def narrow_the_door(self, runner):
        narrow_the_door(os.path.join(runner.workspace, "campus/school.obj"))
        runner.before = self.checkout(runner)

    def digest(self):
        with open(self.package, "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()

    def downloading(self, runner):
        """Makes curl copy the package; the addresses that it was asked for go to the file `urls`."""
        self.write("bin/curl", '#!/bin/sh\nfor last; do :; done\nprintf "%%s\\n" "$last" >>"%s"\n'
                   'while [ "$1" != --output ]; do shift; done\ncp "%s" "$2"\n' % (self.path("urls"), self.package))
        os.chmod(self.path("bin/curl"), 0o755)
        runner.path = self.path("bin") + ":" + runner.path

    def run_action(self, runner, **inputs):
        inputs.setdefault("package", self.package)
        inputs.setdefault("html", "false")
        return runner.run(working_directory="campus", **inputs)

    def assert_uploads_a_new_folder(self, runner):
        """In the runner's temporary folder; the checkout is as it was."""
        (upload,) = runner.uploads.values()
        self.assertTrue(upload.startswith(runner.temp + "/campuswalk/output-"), upload)
        self.assertEqual(upload, runner.outputs["run"]["output"])
        self.assertEqual(self.checkout(runner), runner.before)

    def checkout(self, runner):
        return {name: content for name, content in self.contents().items()
                if name.startswith(os.path.relpath(runner.workspace, self.folder) + "/")}

    def assert_nothing_of_this_machine(self, runner):
        texts = [runner.summary]
        for name in glob.glob(runner.uploads["campuswalk"] + "/*.*"):
            with open(name, encoding="utf-8") as file:
                texts.append(file.read())
        self.assertGreater(len(texts), 2)
        for text in texts:
            self.assertNotIn(self.folder, text)

    def test_a_run_that_passes(self):
        runner = self.runner()
        self.assertEqual(self.run_action(runner), 0, runner.output)
        self.assert_uploads_a_new_folder(runner)
        self.assertIn("::notice title=campuswalk::4 passed", runner.output)
        self.assertIn("## campuswalk: 4 passed", runner.summary)
        self.assertIn("| ✅ | campus/walks/visit.walk.yaml |", runner.summary)
        self.assertIn("(https://github.example/artifacts/7)", runner.summary)
        self.assertEqual(runner.outputs["run"]["exit-code"], "0")
        self.assertTrue(os.listdir(runner.cache["path"]))  # the imported model
        self.assertRegex(runner.cache["key"], r"^campuswalk-[0-9a-f]{16}-hash$")
        self.assert_nothing_of_this_machine(runner)

    def test_a_failure_is_shown_with_its_pictures(self):
        runner = self.runner()
        self.narrow_the_door(runner)
        self.assertEqual(self.run_action(runner), 1, runner.output)
        self.assertIn("::error file=campus/walks/visit.walk.yaml,line=7,col=14,", runner.output)
        self.assertIn("| ❌ | campus/walks/visit.walk.yaml |", runner.summary)
        pictures = re.findall(r"(?m)^- failure.*: (visit/.*png)$", runner.summary.replace("\\", ""))
        self.assertEqual(len(pictures), 6, runner.summary)
        for picture in pictures:
            self.assertTrue(os.path.isfile(os.path.join(runner.uploads["campuswalk"], picture)), picture)
        self.assert_uploads_a_new_folder(runner)
        self.assertEqual(runner.outputs["run"]["exit-code"], "1")
        self.assert_nothing_of_this_machine(runner)

    def test_pictures_that_have_an_address_are_shown(self):
        runner = self.runner()
        self.narrow_the_door(runner)
        self.run_action(runner, pictures_url="https://pictures.example/42", paths="walks/visit.walk.yaml\n")
        self.assertRegex(runner.summary, r"!\[failure.*\]\(<https://pictures\.example/42/visit/failure-.*\.png>\)")

    def test_bad_input_is_annotated(self):
        runner = self.runner()
        with open(runner.workspace + "/campus/walks/visit.walk.yaml", "a", encoding="utf-8") as file:
            file.write("  - reaches: nowhere\n")
        self.assertEqual(self.run_action(runner), 2, runner.output)
        self.assertIn("::error file=campus/walks/visit.walk.yaml,line=14,", runner.output)
        self.assertIn("| 💥 error | campus/walks/visit.walk.yaml |", runner.summary)

    def test_what_may_not_pass_in_ci(self):
        runner = self.runner()
        with open(runner.workspace + "/campus/walks/visit.walk.yaml", "a", encoding="utf-8") as file:
            file.write("status: only\n")
        self.assertEqual(self.run_action(runner), 2, runner.output)

    def play_shards(self, prepare, count=2):
        """Each on a machine of its own, with what `prepare` makes of its checkout. Downloads their artifacts as the next job gets
        them, each in a folder of its name, and returns their exit codes."""
        codes = []
        for i in range(1, count + 1):
            shard = self.runner(f"shard-{i}")
            prepare(shard)
            codes.append(self.run_action(shard, shard=f"{i}/{count}", artifact=f"campuswalk-{i}"))
            self.assertIn("## campuswalk: ", shard.summary)
            shutil.copytree(shard.uploads[f"campuswalk-{i}"], self.path(f"merge/temp/shards/campuswalk-{i}"))
        return codes

    def merge_shards(self, prepare=lambda runner: None, **inputs):
        shutil.rmtree(self.path("merge/workspace"), ignore_errors=True)
        merging = self.runner("merge")
        prepare(merging)
        code = self.run_action(merging, merge=merging.temp + "/shards", **inputs)
        return merging, code

    def test_shards_and_their_merged_report(self):
        whole = self.runner("whole")
        self.narrow_the_door(whole)
        self.assertEqual(self.run_action(whole), 1, whole.output)
        self.assertLessEqual(set(self.play_shards(self.narrow_the_door)), {0, 1})
        merging, code = self.merge_shards()
        self.assertEqual(code, 1, merging.output)
        self.assertEqual(merging.summary, whole.summary)
        pictures = [os.path.relpath(name, whole.uploads["campuswalk"])
                    for name in glob.glob(whole.uploads["campuswalk"] + "/visit/*.png")]
        self.assertGreater(len(pictures), 5)
        for name in ("junit.xml", "results.jsonl", *pictures):
            self.assertTrue(filecmp.cmp(os.path.join(merging.uploads["campuswalk"], name),
                                        os.path.join(whole.uploads["campuswalk"], name), shallow=False), name)
        self.assert_uploads_a_new_folder(merging)

    def test_a_shard_that_is_missing_fails(self):
        self.play_shards(self.narrow_the_door)
        shutil.rmtree(self.path("merge/temp/shards/campuswalk-2"))
        merging, code = self.merge_shards()
        self.assertEqual(code, 1)
        self.assertIn("missing-shard", merging.output)

    def plant_results(self, runner):
        """A pull request whose walk fails, with results that say it passes, wherever an output or a shard's artifact could be."""
        self.narrow_the_door(runner)
        for number in (1, 2):
            for folder in ("out", "shards", f"campuswalk-{number}", f"shards/campuswalk-{number}", "out/shards"):
                os.makedirs(f"{runner.workspace}/campus/{folder}", exist_ok=True)
                shutil.copy(self.path(f"forged-{number}.jsonl"), f"{runner.workspace}/campus/{folder}/results-{number}.jsonl")
        runner.before = self.checkout(runner)

    def test_results_in_a_checkout_replace_no_shards(self):
        forging = self.runner("forging")
        for number in (1, 2):
            self.run_program("run", "-q", "--strict", f"--shard={number}/2", "--output", self.path("elsewhere"), "--reporter",
                             f"jsonl={self.path(f'forged-{number}.jsonl')}", cwd=forging.workspace + "/campus")
        self.assertIn(1, self.play_shards(self.plant_results))
        for number in (1, 2):
            self.assertNotIn(f"results-{3 - number}.jsonl", os.listdir(self.path(f"merge/temp/shards/campuswalk-{number}")))
        merging, code = self.merge_shards(self.plant_results)
        self.assertEqual(code, 1, merging.output)
        shutil.rmtree(self.path("merge/temp/shards/campuswalk-1"))
        merging, code = self.merge_shards(self.plant_results)
        self.assertEqual(code, 1, merging.output)
        self.assertIn("missing-shard", merging.output)

    def test_artifacts_in_the_checkout_are_not_merged(self):
        self.play_shards(lambda runner: None)
        merging = self.runner("merge")
        shutil.copytree(merging.temp + "/shards", merging.workspace + "/campus/shards")
        os.symlink(merging.temp + "/shards", merging.workspace + "/campus/link")
        os.symlink(merging.workspace + "/campus/shards", merging.temp + "/link")
        for folder in ("shards", "link", merging.workspace + "/campus/shards", merging.temp + "/link", "../campus/link/../shards"):
            with self.subTest(folder=folder):
                self.assertEqual(self.run_action(merging, merge=folder), 2, merging.output)
                self.assertEqual(merging.uploads, {})

    def test_the_results_of_another_shard_in_an_artifact_are_refused(self):
        self.play_shards(self.narrow_the_door)
        shards = self.path("merge/temp/shards")
        shutil.copy(shards + "/campuswalk-1/results-1.jsonl", shards + "/campuswalk-2/results-2.jsonl")
        merging, code = self.merge_shards()
        self.assertEqual(code, 2, merging.output)
        self.assertIn("foreign-results", merging.output)

    def test_links_in_a_checkout_lead_nowhere(self):
        runner = self.runner()
        actions = os.path.join(runner.folder, "actions")
        os.makedirs(actions)
        self.write("job/actions/index.js", "genuine\n")
        self.write("job/secret", "key\n")
        for name in ("out", "campus/out", "campus/shards"):
            os.symlink(actions, os.path.join(runner.workspace, name))
        self.assertEqual(self.run_action(runner), 0, runner.output)
        (upload,) = runner.uploads.values()
        for base, folders, names in os.walk(upload):
            self.assertEqual([name for name in folders + names if os.path.islink(os.path.join(base, name))], [])
        self.assertEqual(os.listdir(actions), ["index.js"])

    def test_after_a_refusal_nothing_is_uploaded(self):
        runner = self.runner()
        self.assertEqual(self.run_action(runner, arguments="--min-cases=99"), 2, runner.output)
        self.assertEqual((runner.uploads, runner.summary), ({}, ""))
        self.assertEqual(runner.outputs["run"], {"exit-code": "2"})

    def test_the_sandbox_is_required_unless_somebody_says_otherwise(self):
        self.write("package/campuswalk-9.9.9/bin/campuswalk", '#!/bin/sh\necho "[$*]"\n')
        with tarfile.open(self.package, "w:xz") as archive:
            archive.add(self.path("package/campuswalk-9.9.9"), "campuswalk-9.9.9")
        for name, arguments, expected in (("a", "--strict", True), ("b", "--strict\n--sandbox=auto", False), ("c", "--sandbox\noff", False)):
            runner = self.runner(name)
            self.run_action(runner, arguments=arguments)
            self.assertEqual("--sandbox require" in runner.output, expected, runner.output)

    def test_a_report_in_html(self):
        if not self.with_html:
            self.skipTest("this build has no HTML reports")
        runner = self.runner()
        self.assertEqual(self.run_action(runner, html="true"), 0, runner.output)
        self.assertTrue(os.path.isfile(runner.uploads["campuswalk"] + "/report.html"))

    def test_inputs_are_words_not_commands(self):
        runner = self.runner()
        code = self.run_action(runner, paths="$(touch pwned)\n`touch pwned`\n; touch pwned",
                               arguments="--grep=a b; touch pwned")
        self.assertEqual(code, 5, runner.output)  # no walk is called so
        self.assertEqual([name for name in self.contents() if "pwned" in name], [])
        options = self.runner("options")
        self.assertEqual(self.run_action(options, arguments="  --grep=visit|up stairs\n\n  --min-cases=1\n"), 0, options.output)
        self.assertIn("1 passed", options.summary)

    def test_where_releases_come_from(self):
        with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
            own = re.search(r"campuswalk VERSION ([0-9.]+)", file.read())[1]
        for number, (inputs, expected) in enumerate((({}, f"https://github.com/o/n/releases/download/v{own}/campuswalk-{own}-linux-x86_64.tar.xz"),
                                 ({"version": "1.2.3", "repository": "a/b"},
                                  "https://github.com/a/b/releases/download/v1.2.3/campuswalk-1.2.3-linux-x86_64.tar.xz"),
                                 ({"package": "https://files.example/c.tar.xz"}, "https://files.example/c.tar.xz"))):
            runner = self.runner(f"job-{number}", action_repository="o/n")
            self.downloading(runner)
            self.assertEqual(runner.run(working_directory="campus", html="false", paths="walks/visit.walk.yaml", sha256=self.digest(),
                                        **inputs), 0, runner.output)
            self.assertEqual(self.read("urls").decode().splitlines()[-1], expected)
        unknown = self.runner("unknown")
        self.assertEqual(unknown.run(working_directory="campus"), 2)
        self.assertIn("::error title=campuswalk::say where releases", unknown.output)

    def test_a_package_must_be_the_one_that_was_named(self):
        self.assertEqual(self.run_action(self.runner("right"), sha256=self.digest()), 0)
        wrong = self.runner("wrong")
        self.assertEqual(self.run_action(wrong, sha256="0" * 64), 2)
        self.assertIn("doesn't have the SHA-256", wrong.output)
        self.assertNotIn("passed", wrong.output)
        for package in ("nothing.tar.xz", self.path("room.obj")):
            refused = self.runner("refused-" + package[:3].strip("/"))
            self.assertEqual(self.run_action(refused, package=package), 2)

    def test_a_package_in_the_checkout_needs_its_hash(self):
        for name, package in (("a", "campus/package.tar.xz"), ("b", "campus/link.tar.xz"), ("c", "../workspace/campus/package.tar.xz")):
            runner = self.runner(name)
            shutil.copy(self.package, runner.workspace + "/campus/package.tar.xz")
            os.symlink(self.package, runner.workspace + "/campus/link.tar.xz")
            with self.subTest(package=package):
                self.assertEqual(self.run_action(runner, package=package), 2)
                self.assertIn("is in the checkout", runner.output)
                self.assertNotIn("passed", runner.output)
                self.assertEqual(self.run_action(runner, package=package, sha256=self.digest()), 0, runner.output)

    def test_a_download_that_nobody_vouches_for_is_not_run(self):
        runner = self.runner()
        self.downloading(runner)
        self.assertEqual(self.run_action(runner, package="https://files.example/c.tar.xz"), 2)
        self.assertIn("Its SHA-256 is " + self.digest(), runner.output)
        self.assertNotIn("passed", runner.output)

    def test_a_cache_that_came_with_the_checkout_is_not_used(self):
        runner = self.runner()
        poisoned = PoisonedCache(self, "job/workspace/campus")
        for name in (".campuswalk", "campuswalk"):
            shutil.copytree(os.path.join(runner.workspace, "campus", name), os.path.join(runner.workspace, name))
        self.assertEqual(self.run_action(runner, paths="walks/visit.walk.yaml"), 1, runner.output)
        self.assertFalse(os.path.realpath(runner.cache["path"]).startswith(os.path.realpath(runner.workspace)))
        shutil.copytree(poisoned.elsewhere(), runner.cache["path"], dirs_exist_ok=True)
        self.assertEqual(self.run_action(runner, paths="walks/visit.walk.yaml"), 0, runner.output)  # it would work

    def test_what_others_do_in_it_is_pinned(self):
        with open(os.path.join(ROOT, "action.yml"), encoding="utf-8") as file:
            text = file.read()
        uses = re.findall(r"uses: (.*)", text)
        self.assertEqual(len(uses), 2)
        for each in uses:
            self.assertRegex(each, r"^[a-z]+/[a-z-]+@[0-9a-f]{40} # v[0-9.]+$")
        for step in yaml.safe_load(text)["runs"]["steps"]:
            self.assertNotIn("${{", step.get("run", ""))  # values go through the environment


if __name__ == "__main__":
    Action.with_html = "--with-html" in sys.argv
    sys.argv = [argument for argument in sys.argv if argument != "--with-html"]
    main()
