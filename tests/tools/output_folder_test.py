#!/usr/bin/env python3
"""What may be in the output folder of a run: no links, and where CI is set, nothing that came with a checkout."""

import os
import shutil
import socket

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
        self.assertEqual(self.run_walks("--resume", "--reporter", "list=out/list.txt").code, 0)
        self.write("out/planted", "planted\n")
        self.assert_names(self.run_walks("--resume", "--reporter", "list=out/list.txt"), "foreign-output", "out/planted")


if __name__ == "__main__":
    main()
