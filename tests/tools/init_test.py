#!/usr/bin/env python3
"""`init`: its files run in any folder, and nothing that was there is touched."""

import hashlib
import os
import re
import shutil
import subprocess

import yaml

from poisoned_cache import PoisonedCache
from program import ProgramCase, main
from suggest_test import boxes_obj

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TEMPLATES = ("minimal", "stairs", "campus")


class Init(ProgramCase):
    def test_every_template_validates_and_passes(self):
        for template in TEMPLATES:
            with self.subTest(template=template):
                made = self.passes("init", template, "--template", template)
                self.assertEqual(sorted(made.lines), sorted(name for name, content in self.contents().items()
                                                            if name.startswith(template + "/") and content is not None))
                self.passes("validate", ".", cwd=self.path(template))
                outcome = self.passes("run", "--rendering-backend", "none", cwd=self.path(template))
                for walk in os.listdir(self.path(template + "/walks")):
                    self.assertIn(walk.partition(".")[0], outcome.out)
                self.assertIn("xfail", outcome.out)

    def test_the_same_files_every_time(self):
        self.passes("init", "a", "--template", "campus")
        self.passes("init", "b", "--template", "campus")
        for name, content in self.contents().items():
            if name.startswith("a/"):
                self.assertEqual(self.read("b" + name[1:]) if content is not None else None, content, name)

    def test_the_defaults_are_minimal_and_the_current_folder(self):
        self.passes("init", "one")
        os.makedirs(self.path("two/.git"))
        self.passes("init", cwd=self.path("two"))
        self.assertEqual(sorted(set(os.listdir(self.path("two"))) - {".git"}), sorted(os.listdir(self.path("one"))))

    def refused(self, arguments, start, *names, **options):
        """The diagnostic starts with `start` and contains `names`; nothing is touched."""
        before = self.contents()
        outcome = self.run_program("init", *arguments, **options)
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertTrue(outcome.err.startswith(start), outcome.err)
        self.assertEqual([name for name in names if name not in outcome.err], [])
        self.assertEqual(self.contents(), before)

    def test_nothing_is_overwritten(self):
        self.refused(["avatars"], "avatars: error not-empty: ", "'adult.avatar.yaml'")
        self.refused(["room.obj"], "room.obj: error not-a-folder: ")

    def test_unwritable_folders_are_refused(self):
        self.refused(["room.obj/new"], "room.obj/new: error output-unwritable: ", "'room.obj'")

    def test_a_model_becomes_a_project(self):
        self.write("school/hall.obj", boxes_obj([
            ("meadow", -30, -1, -30, 30, 0, 30), ("Hall_w", -6, 0, -12, -5.8, 3, -4), ("Hall_e", 5.8, 0, -12, 6, 3, -4),
            ("Hall_s1", -6, 0, -4.2, 3, 3, -4), ("Hall_s2", 4, 0, -4.2, 6, 3, -4), ("Hall_n", -6, 0, -12, 6, 3, -11.8)]))
        self.write("school/.gitignore", "mine\n")
        shutil.rmtree(self.path("avatars"))  # the program's own adult, as that is beside no project's
        made = self.passes("init", "--from", "school/hall.obj", "school")
        self.assertIn("school/walks/hall.walk.yaml: 1 visit, played\n", made.out)
        self.assertIn("  closing the doorway at ", made.out)
        self.assertEqual(self.read("school/.gitignore"), b"mine\n")
        for name, schema in (("hall.campus.yaml", "schema/campus"), ("walks/hall.walk.yaml", "../schema/walk")):
            self.assertTrue(self.read("school/" + name).decode().startswith(
                "# yaml-language-server: $schema=" + schema + ".schema.json\n"), name)
        self.passes("validate", ".", cwd=self.path("school"))
        self.passes("run", "--strict", "--forbid-only", "--min-cases", "1", "--rendering-backend", "none", cwd=self.path("school"))
        self.refused(["--from", "school/hall.obj", "school"], "school/walks.config.yaml: error file-exists: ")
        # Without CI, where the model is the current folder's.
        self.write("plain/hall.obj", self.read("school/hall.obj"))
        self.passes("init", "--from", "hall.obj", "--up", "y", "--ci", "none", cwd=self.path("plain"))
        self.assertFalse(os.path.exists(self.path("plain/.github")))

    def test_a_model_that_cannot_become_a_project_leaves_nothing(self):
        self.write("dot/dot.obj", "v 0 0 0\nv 0.05 0 0\nv 0 0.05 0.03\nf 1 2 3\n")
        self.refused(["--from", "dot/dot.obj", "dot"], "dot/dot.obj: error no-ground: ")
        self.refused(["--from", "room.obj", "dot"], "room.obj: error outside-project: ", "'dot'")
        self.refused(["--from", "room.obj", "--template", "campus"], "--template: error bad-value: ")
        self.refused(["new", "--scale", "2"], "--scale: error bad-value: ", "--from")

    def test_a_project_that_is_there_gets_the_file_of_its_ci_and_nothing_else(self):
        for service, name in (("github", ".github/workflows/walks.yml"), ("gitlab", ".gitlab-ci.yml")):
            with self.subTest(service=service):
                self.passes("init", "new-" + service, "--ci", service)
                self.passes("init", service, "--ci", "none")
                before = self.contents()
                added = self.passes("init", service, "--template", "none", "--ci", service)
                self.assertEqual(added.lines, ["%s/%s" % (service, name)])
                after = self.contents()
                self.assertEqual({path for path in after if after[path] is not None} - set(before), {"%s/%s" % (service, name)})
                self.assertEqual({path: after[path] for path in before}, before)
                self.assertEqual(self.read("%s/%s" % (service, name)), self.read("new-%s/%s" % (service, name)))
                self.refused([service, "--template", "none", "--ci", service], "%s/%s: error file-exists: " % (service, name))
        self.refused(["nowhere", "--template", "none"], "nowhere: error not-a-folder: ")
        self.refused(["github", "--template", "none", "--ci", "none"], "--template: error bad-value: ")
        os.makedirs(self.path("linked"))
        os.symlink(self.path("gitlab"), self.path("linked/.github"))
        self.refused(["linked", "--template", "none"], "linked/.github/workflows/walks.yml: error output-unwritable: ")

    def test_the_workflow_is_pinned_and_strict(self):
        for template, walks in (("minimal", 2), ("stairs", 4), ("campus", 5)):
            self.passes("init", template, "--template", template)
            text = self.read(template + "/.github/workflows/walks.yml").decode()
            workflow = yaml.safe_load(text)
            self.assertEqual(workflow["permissions"], {"contents": "read"})
            self.assertNotIn("vars.", text)  # which pull requests from forks don't get
            job = workflow["jobs"]["walks"]
            self.assertLessEqual(job["timeout-minutes"], 60)
            for used in re.findall(r"uses: (.*)", text):
                if not used.startswith("./"):
                    self.assertRegex(used, r"^[^@ ]+@[0-9a-f]{40} # v[0-9.]+$")
            for step in job["steps"]:
                if step.get("uses", "").startswith("actions/checkout@"):
                    self.assertIs(step["with"]["persist-credentials"], False)
            action = job["steps"][-1]["with"]
            self.assertIn("sha256", action)
            arguments = action["arguments"].split()
            self.assertEqual(arguments, ["--strict", "--forbid-only", "--min-cases=%d" % walks])
            self.passes("run", "--rendering-backend", "none", *arguments, cwd=self.path(template))
            with open(os.path.join(ROOT, "action.yml"), encoding="utf-8") as file:
                self.assertLessEqual(set(action), set(yaml.safe_load(file)["inputs"]))

    def test_the_workflow_of_a_build_that_is_not_published_asks_for_the_place(self):
        self.passes("init", "one")
        workflow = yaml.safe_load(self.read("one/.github/workflows/walks.yml"))
        if "env" not in workflow:
            self.skipTest("this build knows its repository")
        [check] = [step["run"] for step in workflow["jobs"]["walks"]["steps"] if "run" in step]

        def code(**variables):
            return subprocess.run(["bash", "-e", "-c", check], check=False, stdout=subprocess.PIPE, cwd=self.path("one"),
                                  env={"PATH": os.environ["PATH"], **workflow["env"], **variables}).returncode
        self.assertEqual(code(), 1)
        self.assertEqual(code(CAMPUSWALK="o/n", CAMPUSWALK_COMMIT="v0.1.0"), 1)
        self.assertEqual(code(CAMPUSWALK="name", CAMPUSWALK_COMMIT="0" * 40), 1)
        self.assertEqual(code(CAMPUSWALK="o/n", CAMPUSWALK_COMMIT="0" * 40), 0)
        os.symlink("../../_actions", self.path("one/.campuswalk"))  # where the action's own checkout would go
        self.assertEqual(code(CAMPUSWALK="o/n", CAMPUSWALK_COMMIT="0" * 40), 1)

    def test_a_pipeline_of_gitlab_finds_its_attachments(self):
        self.passes("init", "one", "--ci", "gitlab")
        self.assertNotIn("one/.github", self.contents())
        job = yaml.safe_load(self.read("one/.gitlab-ci.yml"))["walks"]
        [command] = job["script"]
        self.assertIn(" --strict --forbid-only --min-cases=2 ", command)
        self.assertEqual(job["timeout"], "30 minutes")
        self.write("bin/campuswalk", '#!/bin/sh\nexec "%s" "$@" --rendering-backend none --record csv\n' % self.program)
        os.chmod(self.path("bin/campuswalk"), 0o755)
        command = re.sub(r' --reporter "html=[^"]+"', "", command)  # which not every build writes
        done = subprocess.run(["sh", "-e", "-c", command], cwd=self.path("one"), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False,
                              env={**os.environ, "CI": "true", "CI_PROJECT_DIR": self.path("one"), "CI_COMMIT_SHA": "0" * 40,
                                   "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        self.assertEqual(done.returncode, 0, done.stdout)
        kept = [path.replace("$CI_COMMIT_SHA", "0" * 40) for path in job["artifacts"]["paths"]]
        self.assertNotEqual(kept, job["artifacts"]["paths"])  # no commit can have a folder with its own hash in the name
        report = self.read("one/" + job["artifacts"]["reports"]["junit"].replace("$CI_COMMIT_SHA", "0" * 40)).decode()
        attachments = re.findall(r"\[\[ATTACHMENT\|(.*?)\]\]", report)
        self.assertEqual(len(attachments), 2)
        for attachment in attachments:
            self.assertTrue(os.path.isfile(self.path("one/" + attachment)), attachment)
            self.assertTrue(any(attachment.startswith(path + "/") for path in kept))

    def prepare(self, job, **variables):
        """Runs before_script as GitLab's runner does, one shell for all lines; apt-get and curl only say what they were told."""
        for name in ("apt-get", "curl"):
            self.write("bin/" + name, '#!/bin/sh\necho %s "$@"\n' % name)
            os.chmod(self.path("bin/" + name), 0o755)
        script = "\n".join(line.replace("/tmp/", self.folder + "/") for line in job["before_script"])
        return subprocess.run(["sh", "-e", "-c", script], cwd=self.path("one"), stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, check=False, timeout=60,
                              env={**job["variables"], **variables, "PATH": self.path("bin") + ":" + os.environ["PATH"]})

    def test_a_pipeline_installs_only_the_package_that_it_names(self):
        self.passes("init", "one", "--ci", "gitlab")
        job = yaml.safe_load(self.read("one/.gitlab-ci.yml"))["walks"]
        self.write("campuswalk.deb", "package")
        right = hashlib.sha256(b"package").hexdigest()
        address = "https://files.example/c.deb"
        for variables in ({"CAMPUSWALK": ""}, {"CAMPUSWALK": address}, {"CAMPUSWALK": "", "CAMPUSWALK_SHA256": right}):
            refused = self.prepare(job, **variables)
            self.assertEqual(refused.returncode, 1)
            self.assertEqual(refused.stdout.decode(), "fill in CAMPUSWALK and CAMPUSWALK_SHA256 in .gitlab-ci.yml\n")
        done = self.prepare(job, CAMPUSWALK=address, CAMPUSWALK_SHA256=right)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("apt-get install -y -q %s/campuswalk.deb" % self.folder, done.stdout.decode())
        self.assertIn("curl ", done.stdout.decode())
        os.rename(self.path("campuswalk.deb"), self.path("one/kept.deb"))
        kept = self.prepare(job, CAMPUSWALK="kept.deb", CAMPUSWALK_SHA256=right)
        self.assertEqual(kept.returncode, 0, kept.stdout)
        self.assertNotIn("curl ", kept.stdout.decode())
        self.assertEqual(self.read("campuswalk.deb"), b"package")
        wrong = self.prepare(job, CAMPUSWALK=address, CAMPUSWALK_SHA256="0" * 64)
        self.assertEqual(wrong.returncode, 1)
        self.assertNotIn("campuswalk.deb\n", wrong.stdout.decode().split("FAILED")[-1])

    def test_a_pipeline_trusts_no_cache_that_came_with_the_checkout(self):
        """A good model's cache entries, committed under the names of those of a bad one, make nothing pass."""
        self.passes("init", "one", "--ci", "gitlab")
        job = yaml.safe_load(self.read("one/.gitlab-ci.yml"))["walks"]
        self.assertNotIn("cache", job)
        self.assertNotIn("CAMPUSWALK_CACHE_DIR", job["variables"])
        poisoned = PoisonedCache(self, "one")
        home = self.path("home")  # a new one, like the container
        os.makedirs(home)
        self.write("bin/campuswalk", '#!/bin/sh\nexec "%s" "$@" --rendering-backend none\n' % self.program)
        os.chmod(self.path("bin/campuswalk"), 0o755)
        self.write("campuswalk.deb", "package")
        prepared = self.prepare(job, HOME=home, CAMPUSWALK="https://files.example/c.deb",
                                CAMPUSWALK_SHA256=hashlib.sha256(b"package").hexdigest())
        self.assertEqual(prepared.returncode, 0, prepared.stdout)
        command = re.sub(r' --reporter "html=[^"]+"', "", job["script"][0])

        def code(**variables):
            return subprocess.run(["sh", "-e", "-c", command], cwd=self.path("one"), stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False,
                                  env={"CI": "true", "CI_PROJECT_DIR": self.path("one"), "CI_COMMIT_SHA": "0" * 40, "HOME": home, **job["variables"],
                                       **variables, "PATH": self.path("bin") + ":" + os.environ["PATH"]}).returncode
        self.assertEqual(code(CAMPUSWALK_CACHE_DIR=poisoned.elsewhere()), 0)  # it would work
        self.assertEqual(code(), 1)

    def test_no_service(self):
        self.passes("init", "one", "--ci", "none")
        self.assertEqual([name for name in self.contents() if "/.git" in name and "ignore" not in name], [])

    def test_an_unknown_template_is_refused(self):
        self.assert_bad_usage(self.run_program("init", "new", "--template", "castle"), "campuswalk init",
                              "--template 'castle' campus|minimal|none|stairs")


if __name__ == "__main__":
    main()
