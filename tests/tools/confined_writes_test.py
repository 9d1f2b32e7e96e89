#!/usr/bin/env python3
"""What a checkout says or contains makes the program write nowhere but in the checkout, and replace nothing of others'."""

import os

from program import ROOM, WALK, CheckoutCase, ProgramCase, main, plain_png

KINDS = ("list", "dot", "junit", "tap", "json", "jsonl", "github", "markdown", "log")


class ConfinedWrites(CheckoutCase):
    def setUp(self):
        super().setUp()
        self.write("../victim/precious.txt", "precious")
        self.write("other.walk.yaml", WALK)

    def config(self, text):
        self.write("walks.config.yaml", text)

    def assert_refused_and_untouched(self, expected, *arguments):
        before = self.outer_contents()
        outcome = self.run_program(*(arguments or ("run", "--rendering-backend", "none")))
        self.assertEqual(outcome.code, 2, outcome.err)
        self.assertIn(expected, outcome.err)
        self.assertEqual(self.outer_contents(), before)

    def test_a_configuration_names_places_in_its_folder_only(self):
        for place in ("/nowhere", "../victim", "a/../../victim", self.path("../victim")):
            self.config("output: %s\n" % place)
            self.assert_refused_and_untouched("walks.config.yaml:1:9: error outside-project: ")
            self.config("reporters: [list, {junit: %s/junit.xml}]\n" % place)
            self.assert_refused_and_untouched("walks.config.yaml:1:20: error outside-project: ")
        for place in (".git", ".git/hooks", "a/.git"):
            self.config("output: %s\n" % place)
            self.assert_refused_and_untouched("error outside-project: ")
        for place in ("/dev/stderr", "/dev/null"):
            self.config("reporters: [{tap: %s}]\n" % place)
            self.assert_refused_and_untouched("error outside-project: ")
        self.config("output: ./a/../results\nreporters: [{junit: results/junit.xml}]\n")
        self.passes("run", "--rendering-backend", "none")
        self.assertEqual(sorted(os.listdir(self.path("results"))), [".written.json", "junit.xml", "last-run.jsonl"])

    def test_the_command_line_names_any_place(self):
        self.passes("run", "--rendering-backend", "none", "--output", "../elsewhere", "--reporter", "tap=/dev/null",
                    "--reporter", "junit=../elsewhere/junit.xml")
        self.assertIn("junit.xml", os.listdir(self.path("../elsewhere")))

    def test_folders_that_are_links_are_refused(self):
        os.symlink("../victim", self.path("out"))
        self.assert_refused_and_untouched("'out' is a symbolic link")
        self.assert_refused_and_untouched("'out' is a symbolic link", "run", "--rendering-backend", "none", "--output",
                                          "out/deeper")
        self.assert_refused_and_untouched("'out' is a symbolic link", "run", "short.walk.yaml", "--log", "out/a.log")
        self.assert_refused_and_untouched("'out' is a symbolic link", "run", "short.walk.yaml", "--record", "csv")
        self.assert_refused_and_untouched("'out' is a symbolic link", "info", "room.obj", "--suggest",
                                          "out/new.campus.yaml")
        self.write("../victim/.git/x", "")  # a link's target doesn't begin another project
        self.assert_refused_and_untouched("'out' is a symbolic link")

    def test_files_that_are_links_are_refused(self):
        os.makedirs(self.path("out"))
        for name, arguments in (("junit.xml", ("--reporter", "junit=out/junit.xml")), ("a.log", ("--log", "out/a.log")),
                                ("a.jsonl", ("--jsonl", "out/a.jsonl")), ("last-run.jsonl", ())):
            for target in ("../../victim/precious.txt", "../../victim/new.txt"):
                os.symlink(target, self.path("out/" + name))
                self.assert_refused_and_untouched("is a symbolic link", "run", "--rendering-backend", "none", *arguments)
                os.remove(self.path("out/" + name))

    def test_links_in_a_walks_own_folder_are_refused(self):
        os.makedirs(self.path("out/short"))
        os.symlink("../../../victim/precious.txt", self.path("out/short/trajectory.csv"))
        self.assert_refused_and_untouched("is a symbolic link", "run", "short.walk.yaml", "--record", "csv")

    def test_recordings_are_not_written_through_links(self):
        self.write("below/short.walk.yaml", WALK.replace("campus: ", "campus: ../"))
        for link in ("out/recordings", "out/recordings/below"):
            os.makedirs(self.path(os.path.dirname(link)), exist_ok=True)
            os.symlink(self.path("../victim"), self.path(link))
            self.assert_refused_and_untouched("is a symbolic link", "run", "short.walk.yaml", "below/short.walk.yaml",
                                              "--rendering-backend", "none", "--record", "report")
            os.remove(self.path(link))

    def test_pictures_of_failures_are_not_written_through_links(self):
        self.write("short.walk.yaml", WALK.replace("  - never:", "  - never: popup.open hut\n  - never:"))
        os.makedirs(self.path("out"))
        os.symlink("../../victim", self.path("out/short"))
        outcome = self.run_program("run", "short.walk.yaml", "-q")
        self.assertIn(outcome.code, (1, 2))  # a build without rendering draws none
        self.assertEqual(os.listdir(self.path("../victim")), ["precious.txt"])

    def test_pictures_do_not_replace_golden_images(self):
        for name in ("w.walk.yaml-snapshots.walk.yaml", "w.walk.yaml"):
            self.write("z/" + name, WALK.replace("campus: ", "campus: ../"))
        self.config("output: z\nwalks: z\n")
        self.assert_refused_and_untouched("error output-unwritable: ")

    def test_golden_files_are_written_in_the_project_only(self):
        self.write("../other/short.walk.yaml", WALK.replace("campus: ", "campus: ../checkout/"))
        self.config("walks: ../other\n")
        self.assert_refused_and_untouched("error outside-project: ", "run", "--rendering-backend", "none")
        self.assert_refused_and_untouched("error outside-project: ", "run", "-u", "--rendering-backend", "none")

    def test_golden_files_are_not_written_through_links(self):
        self.write("short.walk.yaml", WALK + "  - log: {golden: true}\n")
        for link in ("short.walk.yaml-snapshots", "short.walk.yaml-snapshots/log.jsonl"):
            for target, reason in ((self.path("../victim/precious.txt"), "leads out of the project"),
                                   (self.path("mine/mine.txt"), "is a symbolic link")):
                self.write("mine/mine.txt", "mine")
                os.makedirs(self.path(os.path.dirname(link)), exist_ok=True)
                os.symlink(target if link.endswith("log.jsonl") else os.path.dirname(target), self.path(link))
                self.assert_refused_and_untouched(reason, "run", "short.walk.yaml", "-u", "--rendering-backend",
                                                  "none")
                self.assertEqual(self.read("mine/mine.txt"), b"mine")
                os.remove(self.path(link))

    def test_golden_files_are_not_written_through_a_link_where_no_project_begins(self):
        self.write("../plain/w.walk.yaml", WALK.replace("small.campus.yaml", "room.campus.yaml") + "  - log: {golden: true}\n")
        for name in ("small.campus.yaml", "room.obj", "avatars/adult.avatar.yaml"):
            self.write("../plain/" + name.replace("small", "room"), self.read(name))
        os.symlink("../victim", self.path("../plain/w.walk.yaml-snapshots"))
        self.assert_refused_and_untouched("symbolic link", "run", "../plain/w.walk.yaml", "-u", "--rendering-backend",
                                          "none", "--root", "..")

    def test_links_below_a_named_folder_are_refused_where_no_project_begins(self):
        os.makedirs(self.path("../plain/out"))
        for name in ("storey-0.png", "any"):
            os.symlink("../../victim/precious.txt", self.path("../plain/out/" + name))
            self.assert_refused_and_untouched("symbolic link", "explore", "small.campus.yaml", "--write-walks", "../plain/out")
            self.assert_refused_and_untouched("symbolic link", "run", "short.walk.yaml", "--rendering-backend", "none", "--record",
                                              "csv", "--output", "../plain/out/")
            os.remove(self.path("../plain/out/" + name))
        os.makedirs(self.path("../plain/linked"))
        os.symlink("../../victim", self.path("../plain/linked/.github"))
        self.assert_refused_and_untouched("symbolic link", "init", "../plain/linked", "--template", "none")

    def test_pictures_replace_no_file_of_the_campus(self):
        wood = "storey-0.png"
        self.write(wood, plain_png(4, 4, (150, 90, 40)))
        self.write("room.mtl", "newmtl wood\nmap_Kd %s\n" % wood)
        self.write("room.obj", ROOM.replace("o floor\n", "mtllib room.mtl\no floor\nusemtl wood\n"))
        for arguments in (("snapshot", "small.campus.yaml", "--camera", "map", "-o", wood),
                          ("route", "small.campus.yaml", "0,0,5", "3,0,5", "--map", wood), ("info", "room.obj", "--map", wood),
                          ("explore", "small.campus.yaml", "--map", ".")):
            with self.subTest(command=arguments[0]):
                if "no-rendering" in self.run_program(*arguments).err:
                    self.skipTest("this build can't draw")
                self.assert_refused_and_untouched("error report-unwritable: this would replace a file that the ", *arguments)
        self.assert_refused_and_untouched("this would replace a file that is compared", "imgdiff", wood, wood, "--diff", wood)

    def test_a_configured_report_replaces_only_its_own_kind(self):
        self.write("notes.txt", "my notes")
        self.write("source.py", "\nimport os\n")
        for name in ("room.obj", "notes.txt", "source.py", "small.campus.yaml", ".git/config"):
            self.write(".git/config", "[core]\n")
            for kind in KINDS:
                self.config("reporters: [{%s: %s}]\n" % (kind, name))
                self.assert_refused_and_untouched("error ")
        for kind in KINDS:
            for quiet in ((), ("-q",)):
                self.config("reporters: [{%s: report}]\n" % kind)
                for _ in range(2):
                    self.assertEqual(self.run_program("run", "--rendering-backend", "none", *quiet).code, 0, kind)
                os.remove(self.path("report"))

    def test_a_report_on_the_command_line_replaces_anything_but_inputs(self):
        self.write("notes.txt", "my notes")
        self.passes("run", "--rendering-backend", "none", "--reporter", "tap=notes.txt")
        self.assertTrue(self.read("notes.txt").startswith(b"TAP"))
        for name in ("room.obj", "./room.obj", self.path("room.obj")):
            self.assert_refused_and_untouched("error report-unwritable: ", "run", "--rendering-backend", "none",
                                              "--reporter", "tap=" + name)
            self.assert_refused_and_untouched("error report-unwritable: ", "run", "--rendering-backend", "none",
                                              "--save", name)
            for option in ("--json", "--geojson"):
                self.assert_refused_and_untouched("error report-unwritable: ", "explore", "small.campus.yaml", option, name)

    def test_pictures_do_not_replace_textures(self):
        self.write("short/view.txt", "")
        self.write("room.mtl", "newmtl brick\nmap_Kd short/view.png\n")
        self.write("room.obj", b"mtllib room.mtl\nusemtl brick\n" + self.read("room.obj"))
        self.write("short/view.png", b"\x89PNG\r\n\x1a\n")
        self.config("output: .\n")
        self.assert_refused_and_untouched("error output-unwritable: ")


class Search(ProgramCase):
    """walks.config.yaml and profiles are looked for upwards to the root of the repository."""

    def run_below(self):
        return self.run_program("run", "--print-config", cwd=self.path("repository/deeper"))

    def setUp(self):
        super().setUp()
        os.makedirs(self.path("repository/deeper"))

    def test_ends_at_the_repositorys_root(self):
        self.write("walks.config.yaml", "workers: 7\n")
        self.assertIn('"workers": 7', self.run_below().out)
        os.makedirs(self.path("repository/.git"))
        self.assertNotIn('"workers": 7', self.run_below().out)
        self.write("repository/walks.config.yaml", "workers: 8\n")
        self.assertIn('"workers": 8', self.run_below().out)

    def test_ends_where_the_owner_changes(self):
        self.write("walks.config.yaml", "workers: 7\n")
        try:
            os.chown(self.folder, 65534, 65534)
        except PermissionError:
            self.skipTest("only root can give folders away")
        self.assertNotIn('"workers": 7', self.run_below().out)

    def test_profiles_come_from_the_repository(self):
        self.write("repository/deeper/short.walk.yaml", WALK.replace("campus: ", "campus: ../../").replace("adult", "tall"))
        self.write("avatars/tall.avatar.yaml", "height: 2.0\nradius: 0.3\n")
        arguments = ("run", "--rendering-backend", "none", "repository/deeper/short.walk.yaml")
        self.passes(*arguments)
        os.makedirs(self.path("repository/.git"))
        outcome = self.run_program(*arguments)
        self.assertEqual(outcome.code, 2)
        self.assertIn("error unknown-name: ", outcome.err)


if __name__ == "__main__":
    main()
