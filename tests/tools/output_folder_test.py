#!/usr/bin/env python3
"""What may be in the output folder of a run: no links, and where CI is set, nothing that came with a checkout."""

import os
import resource
import shutil
import socket
import subprocess

from program import WALK, ProgramCase, main


class OutputFolder(ProgramCase):
    KEY = "0123456789abcdef0123"

    def setUp(self):
        super().setUp()
        self.write("other.walk.yaml", WALK)

    def run_walks(self, *arguments, ci=True, key=KEY):
        variables = {**os.environ, "CAMPUSWALK_RUN_KEY": key, "XDG_STATE_HOME": self.path("state"), **({"CI": "true"} if ci else {})}
        return self.run_program("run", "-q", "--rendering-backend", "none", "--record", "csv", *arguments, env=variables)

    def assert_names(self, outcome, code, name):
        self.assert_refused(outcome, f"{name}: error {code}:")

    def refuses(self, code, name, *arguments, **options):
        before = self.contents()
        self.assert_names(self.run_walks(*arguments, **options), code, name)
        self.assertEqual(self.contents(), before)

    def test_links_are_refused_at_any_depth(self):
        self.write("secret", "key\n")
        os.makedirs(self.path("secrets"))
        for name, target in (("out/link", "../secret"), ("out/deep/er/link", "../../../secrets"), ("out/env", "/proc/self/environ"),
                             ("out/nowhere", "missing"), ("out/.hidden", "../secret")):
            os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
            os.symlink(target, self.path(name))
            for ci in (True, False):
                with self.subTest(name=name, ci=ci):
                    self.assert_names(self.run_walks(ci=ci), "output-unwritable", name)
            os.remove(self.path(name))
        self.assertEqual(self.run_walks().code, 0)

    def deepen(self, folder, levels, count):
        """More levels than a process may open files. They come before and after others, in whichever order these are listed."""
        self.addCleanup(subprocess.run, ["rm", "-rf", self.path(folder)], check=False)
        for number in range(count):
            here = self.path(os.path.join(folder, f"d{number}"))
            os.makedirs(here)
            at = os.open(here, os.O_RDONLY | os.O_DIRECTORY)
            for _ in range(levels):
                os.mkdir("d", dir_fd=at)
                below = os.open("d", os.O_RDONLY | os.O_DIRECTORY, dir_fd=at)
                os.close(at)
                at = below
            os.close(at)

    def limited(self, *arguments):
        """With 128 open files at most."""
        def limit():
            resource.setrlimit(resource.RLIMIT_NOFILE, (128, 128))
        return self.run_program(*arguments, preexec_fn=limit, env={**os.environ, "CAMPUSWALK_RUN_KEY": self.KEY, "CI": "true"})

    def test_deep_folders_hide_nothing(self):
        self.deepen("out", 200, 8)
        os.symlink("/etc/passwd", self.path("out/link"))
        self.assert_names(self.limited("run", "-q"), "output-unwritable", "out/link")
        os.remove(self.path("out/link"))
        self.write("out/planted", "planted\n")
        self.assert_names(self.limited("run", "-q"), "foreign-output", "out/planted")
        os.remove(self.path("out/planted"))
        self.assertEqual(self.limited("run", "-q").code, 0)

    def test_deep_folders_hide_no_broken_file_from_validate(self):
        self.deepen("a", 200, 8)
        self.write("b/broken.walk.yaml", "campus: [\n")
        outcome = self.limited("validate", ".")
        self.assertEqual(outcome.code, 2)
        self.assertIn("b/broken.walk.yaml:", outcome.err)

    def test_no_option_but_that_of_a_job_makes_it_tolerant(self):
        self.write("out/state/junit.xml", "planted\n")
        self.assert_names(self.run_walks("--save", "out/state/last.jsonl", "--shard=1/2"), "foreign-output", "out/state/junit.xml")

    def test_a_key_in_a_checkout_is_nobodys(self):
        """Who can commit the key could sign a list."""
        os.makedirs(self.path("home/.git"))
        for variables in ({"HOME": self.path("home")}, {"XDG_STATE_HOME": self.path("home/states"), "HOME": "/"}):
            with self.subTest(variables=variables):
                def run(variables=variables, **more):
                    return self.run_program("run", "-q", env={**{name: value for name, value in os.environ.items()
                                                              if name not in ("XDG_STATE_HOME", "CAMPUSWALK_RUN_KEY")}, **variables, **more})
                self.assertEqual(run(CI="true").code, 0)
                self.assertEqual([name for name in self.contents() if name.endswith("run.key")], [])
                outcome = run(CI="true")
                self.assertEqual(outcome.code, 2)
                self.assertIn("CAMPUSWALK_RUN_KEY", outcome.err)
                shutil.rmtree(self.path("out"))

    def test_what_is_neither_file_nor_folder_is_refused(self):
        os.makedirs(self.path("out"))
        os.mkfifo(self.path("out/pipe"))
        self.assert_names(self.run_walks(ci=False), "output-unwritable", "out/pipe")
        os.remove(self.path("out/pipe"))
        with socket.socket(socket.AF_UNIX) as listening:
            listening.bind(self.path("out/socket"))
            self.assert_names(self.run_walks(ci=False), "output-unwritable", "out/socket")

    def test_a_file_that_came_with_the_checkout_is_refused_in_ci_only(self):
        for name in ("out/results-1.jsonl", "out/short/trajectory.csv", "out/a/b/c", "out/.hidden", "out/x.1-0.part",
                     "out/campuses/small.json", "out/.written.json"):
            with self.subTest(name=name):
                self.write(name, "planted\n")
                self.refuses("foreign-output", name)
                self.assertEqual(self.run_walks(ci=False).code, 0)
                shutil.rmtree(self.path("out"))

    def test_runs_of_the_same_user_follow_each_other(self):
        for arguments in ((), ("--reporter", "junit=out/j.xml", "--reporter", "jsonl=out/r.jsonl"), ("other.walk.yaml",),
                          ("--shard=2/2",), ("short.walk.yaml", "--log", "out/log.txt")):
            outcome = self.run_walks(*arguments)
            self.assertEqual((outcome.code, outcome.err), (0, outcome.err), arguments)
        self.assertEqual(self.run_walks(key="").code, 2)  # without the key nobody knows whose they are

    def test_the_key_of_this_machine_is_enough(self):
        self.assertEqual([self.run_walks(key="").code for _ in range(3)], [0, 0, 0])

    def test_what_is_added_to_or_changed_in_an_earlier_output_is_refused(self):
        self.assertEqual(self.run_walks().code, 0)
        self.write("out/short/more.csv", "planted\n")
        self.refuses("foreign-output", "out/short/more.csv")
        os.remove(self.path("out/short/more.csv"))
        trajectory = self.read("out/short/trajectory.csv")
        self.write("out/new", trajectory)
        os.rename(self.path("out/new"), self.path("out/short/trajectory.csv"))  # as git replaces a file
        self.refuses("foreign-output", "out/short/trajectory.csv")
        self.assertEqual(self.run_walks(ci=False).code, 0)  # which writes it again
        self.assertEqual(self.run_walks().code, 0)
        with open(self.path("out/other/trajectory.csv"), "ab") as file:
            file.write(b"planted\n")
        self.refuses("foreign-output", "out/other/trajectory.csv")

    def test_what_was_there_before_a_run_outside_of_ci_is_not_taken_for_its_output(self):
        self.write("out/planted", "planted\n")
        self.assertEqual(self.run_walks(ci=False).code, 0)
        self.refuses("foreign-output", "out/planted")

    def test_a_list_and_its_files_that_are_copied_prove_nothing(self):
        self.assertEqual(self.run_walks().code, 0)
        shutil.copytree(self.path("out"), self.path("planted"))
        self.assert_names(self.run_walks("--output", "planted"), "foreign-output", "planted/last-run.jsonl")

    def test_a_list_of_another_user_proves_nothing(self):
        self.assertEqual(self.run_walks(key="another key of 21 bytes").code, 0)
        self.refuses("foreign-output", "out/.written.json")

    def test_a_run_that_was_killed_can_be_continued_in_ci(self):
        self.assertEqual(self.run_walks("--reporter", "list=out/list.txt").code, 0)
        os.remove(self.path("out/.written.json"))  # it is written at the end
        self.refuses("foreign-output", "out/last-run.jsonl")
        self.write("out/j.xml.campuswalk-12345-0.part", "half\n")
        self.assertEqual(self.run_walks("--resume", "--reporter", "list=out/list.txt", "--reporter", "junit=out/j.xml").code, 0)
        self.assertFalse(os.path.exists(self.path("out/j.xml.campuswalk-12345-0.part")))
        self.write("out/planted", "planted\n")
        self.assert_names(self.run_walks("--resume", "--reporter", "list=out/list.txt"), "foreign-output", "out/planted")


if __name__ == "__main__":
    main()
