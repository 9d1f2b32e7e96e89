#!/usr/bin/env python3
"""Where a checkout has a pipe or a hard link in place of a file, nothing waits for the pipe, and what the link is another name
of stays as it is. Streams that the user names are written to."""

import os
import subprocess
import threading

from program import WALK, CheckoutCase, main

NO_PICTURES = ("--rendering-backend", "none")
STREAMS = ("list", "dot", "tap", "jsonl", "github", "log")
WHOLE = ("junit", "json", "markdown")
LONGEST = 60  # seconds, for what would take forever


class Pipes(CheckoutCase):
    def setUp(self):
        super().setUp()
        self.write("../victim/precious.txt", "precious")
        self.write("other.walk.yaml", WALK)

    def run_program(self, *arguments, **options):
        try:
            return super().run_program(*arguments, longest=LONGEST, **options)
        except subprocess.TimeoutExpired:
            self.fail("%s waits" % (arguments,))

    def pipe(self, name):
        if os.path.lexists(self.path(name)):
            os.remove(self.path(name))
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        os.mkfifo(self.path(name))

    def hard_link(self, name):
        if os.path.lexists(self.path(name)):
            os.remove(self.path(name))
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        os.link(self.path("../victim/precious.txt"), self.path(name))

    def assert_precious(self):
        self.assertEqual(self.read("../victim/precious.txt"), b"precious")

    def assert_pipe_refused(self, name, *arguments):
        """Exit code 2, and the pipe is named."""
        outcome = self.run_program(*arguments)
        self.assertEqual(outcome.code, 2, outcome.out + outcome.err)
        self.assertIn(os.path.basename(name), outcome.err)

    # What is written.

    def test_hard_links_are_replaced(self):
        for kind in STREAMS + WHOLE:
            name = "out/report"
            self.hard_link(name)
            self.passes("run", *NO_PICTURES, "--reporter", "%s=%s" % (kind, name))
            self.assert_precious()
            self.assertNotEqual(self.read(name), b"precious", kind)
        for arguments in (("--log", "out/a"), ("--jsonl", "out/a")):
            self.hard_link("out/a")
            self.passes("run", "short.walk.yaml", *arguments)
            self.assert_precious()
            self.assertNotEqual(self.read("out/a"), b"precious")
        for record in ("csv", "report"):
            self.hard_link("out/short/trajectory.csv")
            self.hard_link("out/recordings/short.json")
            self.passes("run", *NO_PICTURES, "--record", record)
            self.assert_precious()

    def test_saved_results_are_replaced(self):
        self.hard_link("out/last-run.jsonl")
        self.passes("run", *NO_PICTURES)
        self.assert_precious()
        saved = self.read("out/last-run.jsonl")
        self.assertEqual(len(saved.splitlines()), 3)
        self.write("out/last-run.jsonl", b"".join(saved.splitlines(True)[:2]))
        os.link(self.path("out/last-run.jsonl"), self.path("../victim/saved"))
        self.passes("run", *NO_PICTURES, "--resume")
        self.assertEqual(self.read("../victim/saved"), b"".join(saved.splitlines(True)[:2]))
        self.assertEqual(len(self.read("out/last-run.jsonl").splitlines()), 3)

    def test_pipes_in_the_output_folder_are_refused(self):
        for name, arguments in (("out/last-run.jsonl", ()), ("out/short/trajectory.csv", ("--record", "csv")),
                                ("out/recordings/short.json", ("--record", "report"))):
            self.pipe(name)
            self.assert_pipe_refused(name, "run", *NO_PICTURES, *arguments)
            os.remove(self.path(name))

    def test_pipes_that_the_configuration_names_are_refused(self):
        for kind in STREAMS + WHOLE:
            self.write("walks.config.yaml", "reporters: [{%s: report}]\n" % kind)
            self.pipe("report")
            self.assert_pipe_refused("report", "run", *NO_PICTURES)
            os.remove(self.path("report"))

    def test_pipes_are_not_replaced_by_what_is_written_whole(self):
        for arguments in (("info", "room.obj", "--suggest", "pipe.campus.yaml"),
                          ("explore", "small.campus.yaml", "--json", "pipe"), ("explore", "small.campus.yaml", "--geojson", "pipe"),
                          ("route", "small.campus.yaml", "start", "end", "--write", "pipe.steps.yaml")):
            self.pipe(arguments[-1])
            self.assert_pipe_refused(arguments[-1], *arguments)
            os.remove(self.path(arguments[-1]))

    def test_pipes_that_the_user_names_are_written_to(self):
        for kind in STREAMS + WHOLE:
            self.pipe("../pipe")
            read = []
            with open(os.open(self.path("../pipe"), os.O_RDONLY | os.O_NONBLOCK), "rb") as pipe:
                os.set_blocking(pipe.fileno(), True)
                reader = threading.Thread(target=lambda: read.append(pipe.read()))
                with open(self.path("../pipe"), "wb"):  # the end doesn't come before the program opens it
                    reader.start()
                    self.passes("run", *NO_PICTURES, "--reporter", "%s=../pipe" % kind)
                reader.join()
            self.passes("run", *NO_PICTURES, "--reporter", "%s=file" % kind)
            self.assertEqual(read, [self.read("file")])

    def test_standard_output_is_not_replaced(self):
        for kind in ("tap", "junit"):
            with open(self.path("stdout"), "wb") as stdout:
                self.passes("run", "-q", *NO_PICTURES, "--reporter", kind + "=/dev/stdout", stdout=stdout)
                self.assertEqual(os.fstat(stdout.fileno()).st_nlink, 1)
                self.assertEqual(os.fstat(stdout.fileno()).st_ino, os.stat(self.path("stdout")).st_ino)
            self.passes("run", "-q", *NO_PICTURES, "--reporter", kind + "=file")
            self.assertEqual(self.read("stdout"), self.read("file"))

    # What is read.

    def test_inputs_that_are_pipes_are_refused(self):
        for name, arguments in (("short.walk.yaml", ("run", "short.walk.yaml")), ("small.campus.yaml", ("run", "short.walk.yaml")),
                                ("small.campus.yaml", ("explore", "small.campus.yaml")), ("room.obj", ("run", "short.walk.yaml")),
                                ("room.obj", ("info", "room.obj")), ("avatars/adult.avatar.yaml", ("run", "short.walk.yaml")),
                                ("short.walk.yaml", ("validate", "short.walk.yaml")),
                                ("walks.config.yaml", ("run",))):
            kept = self.read(name) if os.path.exists(self.path(name)) else None
            self.pipe(name)
            self.assert_pipe_refused(name, *arguments)
            os.remove(self.path(name))
            if kept is not None:
                self.write(name, kept)

    def test_reports_and_logs_that_are_pipes_are_refused(self):
        self.pipe("pipe")
        self.pipe("pipe.png")
        for arguments in (("merge-reports", "pipe"), ("replay", "pipe"), ("diff", "pipe", "pipe"), ("imgdiff", "pipe.png", "pipe.png"),
                          ("run", "--shard", "1/2", "--shard-times", "pipe"), ("import", "osm", "pipe", "-o", "campus"),
                          ("info", "room.obj", "--suggest", "new.campus.yaml", "--places", "pipe")):
            self.assert_pipe_refused("pipe", *arguments)
        self.pipe("out/last-run.jsonl")
        self.assert_pipe_refused("last-run.jsonl", "run", *NO_PICTURES, "--last-failed")

    def test_golden_files_that_are_pipes_are_refused(self):
        self.write("short.walk.yaml", WALK + "  - log: {golden: true}\n")
        self.pipe("short.walk.yaml-snapshots/log.jsonl")
        outcome = self.run_program("run", "short.walk.yaml", *NO_PICTURES)
        self.assertIn(outcome.code, (1, 2), outcome.err)
        self.assertIn("log.jsonl", outcome.out + outcome.err)

    def test_what_models_name_may_be_pipes(self):
        self.write("room.obj", b"mtllib room.mtl\n" + self.read("room.obj"))
        self.pipe("room.mtl")
        self.passes("run", "short.walk.yaml", "--no-cache", *NO_PICTURES)
        self.write("map.osm", '<osm version="0.6"><node id="1" lat="0.0005" lon="0.0005"/><node id="2" lat="0.0006" lon="0.0005"/>'
                   '<way id="3"><nd ref="1"/><nd ref="2"/><tag k="highway" v="footway"/></way></osm>')
        self.pipe("heights.asc")
        self.assert_pipe_refused("heights.asc", "import", "osm", "map.osm", "-o", "campus", "--bbox", "0,0,0.001,0.001", "--heights", "heights.asc")


class CommittedLinks(CheckoutCase):
    """A link of a checkout that leads to a stream isn't what somebody means who names a file there."""

    def test_no_report_or_log_is_written_through_one(self):
        os.mkfifo(os.path.join(self.outer, "pipe"))
        for target in ("/dev/null", "/proc/self/comm", os.path.join(self.outer, "pipe"), "/dev/fd/1"):
            for name, arguments in (("r.xml", ("--reporter", "junit=r.xml")), ("r.txt", ("--reporter", "list=r.txt")),
                                    ("log.txt", ("--log", "log.txt")), ("e.jsonl", ("--jsonl", "e.jsonl"))):
                with self.subTest(target=target, name=name):
                    os.symlink(target, self.path(name))
                    outcome = self.run_program("run", "short.walk.yaml", *arguments)
                    self.assertEqual((outcome.code, outcome.out), (2, ""), outcome.err)
                    self.assertIn("is a symbolic link", outcome.err)
                    os.remove(self.path(name))

    def test_streams_that_the_user_names_are_written_to(self):
        self.assertIn("pass", self.passes("run", "short.walk.yaml", "--reporter", "list=/dev/stdout").out)


if __name__ == "__main__":
    main()
