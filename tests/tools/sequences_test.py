#!/usr/bin/env python3
"""`run --every`, `--contact-sheet`, `--animation`, `--video`. `sequences_test.py PROGRAM [--without-rendering]`."""

import json
import os
import pathlib
import signal
import struct
import subprocess
import sys
import time
import unittest

from program import WALK, ProgramCase, main

WITHOUT_RENDERING = "--without-rendering" in sys.argv

# A substitute for ffmpeg that stores its arguments and its input.
FFMPEG = """#!/bin/sh
echo "$@" > "$FFMPEG_ARGUMENTS"
for last; do :; done
cat > "$last"
"""


class Sequences(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("short.walk.yaml", WALK.replace("avatar: adult", "avatar: adult\ncamera: {width: 64, height: 48}"))

    def frames(self, folder="out/short/frames"):
        return sorted(name for name in self.contents() if name.startswith(folder + "/"))

    @staticmethod
    def children_of(process):
        try:
            return pathlib.Path("/proc/%d/task/%d/children" % (process, process)).read_text("ascii").split()
        except FileNotFoundError:
            return []

    def forked_by(self, process):
        """The only forked child, once it exists. The importer has other arguments, except for a moment at its start."""
        for _ in range(1000):
            for child in self.children_of(process):
                try:
                    if pathlib.Path("/proc", child, "cmdline").read_bytes() == pathlib.Path(
                            "/proc/%d/cmdline" % process).read_bytes():
                        return int(child)
                except FileNotFoundError:
                    pass  # it has ended
            time.sleep(0.01)
        return self.fail("process %d has no child like itself" % process)

    def size_of(self, name):
        return struct.unpack(">II", self.read(name)[16:24])

    def refused(self, *arguments, expected, **options):
        before = self.contents()
        outcome = self.run_program("run", "short.walk.yaml", *arguments, **options)
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, expected)
        self.assertEqual(self.contents(), before)


@unittest.skipIf(WITHOUT_RENDERING, "this build draws nothing")
class Drawn(Sequences):
    def test_frames_are_written_at_intervals(self):
        plain = self.passes("run", "short.walk.yaml").out
        self.assertNotIn("out", self.contents())
        outcome = self.passes("run", "short.walk.yaml", "--every", "0.5")
        self.assertEqual(outcome.out, plain, "drawing changes no log")
        seconds = [float(line.split()[1]) for line in outcome.lines if line[:1].isdigit()][-1]
        frames = self.frames()
        self.assertEqual(frames[0], "out/short/frames/frame-00001.png")
        self.assertEqual(len(frames), int(seconds / 0.5 + 1e-6) + 1)
        self.assertEqual(self.size_of(frames[0]), (64, 48))
        self.assertNotEqual(self.read(frames[0]), self.read(frames[5]))
        self.passes("run", "short.walk.yaml", "--every", "2")
        self.assertEqual(len(self.frames()), int(seconds / 2 + 1e-6) + 1, "the previous run's frames are removed")

    def test_frames_are_the_same_bytes_with_any_number_of_workers(self):
        self.write("other.walk.yaml", self.read("short.walk.yaml"))
        for folder, workers in (("one", "1"), ("two", "2")):
            self.passes("run", ".", "--every", "1", "--animation", "apng", "--animation", "gif", "--contact-sheet",
                        "-j", workers, "--output", folder)
        for name in ("animation.png", "animation.gif", "contact-sheet.png", "frames/frame-00003.png"):
            for walk in ("short", "other"):
                self.assertEqual(self.read("one/%s/%s" % (walk, name)), self.read("two/%s/%s" % (walk, name)))

    def test_frames_of_one_walk_are_drawn_by_idle_processes(self):
        made = ("animation.png", "contact-sheet.png", "frames/frame-00002.png", "frames/frame-00004.png")
        arguments = ("run", "short.walk.yaml", "--every", "0.1", "--animation", "apng", "--contact-sheet", "--output")
        alone = self.passes(*arguments, "one", "-j", "1")
        for workers in ("2", "5"):
            outcome = self.passes(*arguments, "many", "-j", workers)
            self.assertEqual(outcome.out, alone.out)
            self.assertEqual(outcome.err, alone.err)
            self.assertEqual(len(self.frames("many/short/frames")), len(self.frames("one/short/frames")))
            for name in made:
                self.assertEqual(self.read("one/short/" + name), self.read("many/short/" + name), name)

    def test_a_killed_drawing_process_is_an_error(self):
        self.passes("run", "short.walk.yaml")  # fills the cache, so that nothing is imported below
        with subprocess.Popen([self.program, "run", "short.walk.yaml", "--every", "0.02", "--frame-width", "1000", "-j", "2"],
                              cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as run:
            worker = self.forked_by(run.pid)
            os.kill(self.forked_by(worker), signal.SIGKILL)
            errors = run.communicate(timeout=120)[1].decode()
        self.assertEqual(run.returncode, 3)
        self.assertRegex(errors, r"error: .*signal 9 \(Killed\)")

    def test_an_interrupt_ends_all_processes(self):
        self.passes("run", "short.walk.yaml")
        with subprocess.Popen([self.program, "run", "short.walk.yaml", "--every", "0.02", "--frame-width", "1000", "-j", "2"],
                              cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              start_new_session=True) as run:
            helper = self.forked_by(self.forked_by(run.pid))
            os.killpg(run.pid, signal.SIGINT)  # to all of them, as a terminal does
            errors = run.communicate(timeout=120)[1].decode()
        self.assertEqual((run.returncode, errors.splitlines()[-1]), (130, "interrupted"))
        self.assertFalse(os.path.exists("/proc/%d/cwd" % helper), "the helper ends with the others")

    def test_views_and_sizes(self):
        images = []
        for view in ("first_person", "third_person", "top"):
            self.passes("run", "short.walk.yaml", "--every", "1", "--frame-view", view, "--frame-width", "40")
            self.assertEqual(self.size_of(self.frames()[0]), (40, 30))
            images.append(self.read(self.frames()[0]))
        self.assertEqual(len(set(images)), 3)

    def test_contact_sheets_and_animations_need_no_frames(self):
        self.passes("run", "short.walk.yaml", "--contact-sheet", "--animation=apng", "--animation=gif", "--reporter",
                    "json=report.json")
        self.assertEqual(self.frames(), [])
        made = [(each["name"], each["path"], each["media_type"])
                for each in json.loads(self.read("report.json"))["results"][0]["artifacts"]]
        self.assertEqual(made, [("contact sheet", "short/contact-sheet.png", "image/png"),
                                ("animation", "short/animation.png", "image/apng"),
                                ("animation", "short/animation.gif", "image/gif")])
        self.assertIn(b"acTL", self.read("out/short/animation.png")[:60])
        self.assertEqual(self.read("out/short/animation.gif")[:6], b"GIF89a")

    def test_video(self):
        os.makedirs(self.path("bin"))
        self.write("bin/ffmpeg", FFMPEG)
        os.chmod(self.path("bin/ffmpeg"), 0o755)
        environment = {**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"],
                       "FFMPEG_ARGUMENTS": self.path("arguments")}
        self.passes("run", "short.walk.yaml", "--video", "--every", "0.25", env=environment)
        arguments = self.read("arguments").decode()
        self.assertIn("-pix_fmt rgba -video_size 64x48 -framerate 4.000000 -i pipe:0", arguments)
        self.assertEqual(len(self.read("out/short/video.mp4")), len(self.frames()) * 64 * 48 * 4)
        self.write("bin/ffmpeg", "#!/bin/sh\necho no such codec >&2\nexit 1\n")
        os.remove(self.path("out/short/video.mp4"))
        outcome = self.run_program("run", "short.walk.yaml", "--video", env=environment)
        self.assertEqual(outcome.code, 3)
        self.assertIn("no such codec", outcome.err)
        self.assertRegex(outcome.err, "error: .*out/short/video.mp4.*ffmpeg")
        self.assertEqual([name for name in self.contents() if "video" in name], [])

    def test_video_without_ffmpeg_is_refused(self):
        os.makedirs(self.path("bin"))
        self.refused("--video", expected="--video: error bad-value: ffmpeg --animation",
                     env={**os.environ, "PATH": self.path("bin")})

    def test_frames_without_a_backend_are_refused(self):
        for arguments in (("--every", "1"), ("--contact-sheet",)):
            self.refused(*arguments, "--rendering-backend", "none",
                         expected="--every: error bad-value: --rendering-backend")

    def test_unwritable_output_is_refused(self):
        self.refused("--every", "1", "--output", "room.obj",
                     expected="room.obj/short: error output-unwritable: 'room.obj'")


@unittest.skipUnless(WITHOUT_RENDERING, "this build draws")
class NothingIsDrawn(Sequences):
    def test_frames_are_refused(self):
        self.refused("--every", "1", expected="--every: error bad-value: CAMPUSWALK_RENDER=ON")


if __name__ == "__main__":
    if WITHOUT_RENDERING:
        sys.argv.remove("--without-rendering")
    main()
