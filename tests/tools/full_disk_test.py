#!/usr/bin/env python3
"""A disk that becomes full at any write: the command says so, nothing half-written counts, and once there is room
again the results are those of an undisturbed run. On small disks in a mount namespace of its own; skipped where
the system allows none.
"""

import os
import shutil
import subprocess
import sys
import tempfile

from program import FILES, SKIPPED, WALK, ProgramCase, main

WITHOUT_RENDERING = "--without-rendering" in sys.argv
DISK = 8 << 20  # bytes
PAGE = 4096
FULL = "No space left on device"


class FullDisk(ProgramCase):
    def setUp(self):
        super().setUp()
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=%d" % DISK, "full", self.folder], check=True)
        self.addCleanup(subprocess.run, ["umount", "-l", self.folder], check=False)
        for name, text in FILES.items():
            self.write(name, text)
        for i in range(4):
            self.write("w%d.walk.yaml" % i, WALK)
        self.filler = self.path("filler")

    def leave_pages(self, pages):
        """So many free pages for data; a file's name takes none."""
        with open(self.filler, "wb") as file:
            free = os.statvfs(self.folder).f_bavail * PAGE
            file.write(b"\1" * max(free - pages * PAGE, 0))

    def make_room(self):
        os.remove(self.filler)

    def run_on_full_disk(self, pages, *arguments):
        """Returns the exit code."""
        self.leave_pages(pages)
        outcome = self.run_program(*arguments)
        said = outcome.err
        self.make_room()
        self.assertIn(outcome.code, (0, 1, 2, 3), said)
        if outcome.code in (2, 3):
            self.assertIn(FULL, said, arguments)
        parts = [name for name in self.contents() if name.endswith(".part")]
        self.assertEqual(parts, [], "half a file is left")
        return outcome.code

    def remove(self, names):
        for name in names:
            shutil.rmtree(self.path(name), ignore_errors=True)
            if os.path.isfile(self.path(name)):
                os.remove(self.path(name))

    def check(self, command, whole, remove):
        """With any number of free pages: `whole` are files that must be complete or missing."""
        self.passes(*command)
        expected = {name: self.read(name) for name in whole}
        codes = []
        for pages in (*range(12), 20, 40, 80, 160, 320, 640, 1200):
            self.remove(remove)
            codes.append(self.run_on_full_disk(pages, *command))
            for name, content in expected.items():
                if os.path.exists(self.path(name)):
                    self.assertEqual(self.read(name), content, "%s, %d pages" % (name, pages))
                else:
                    self.assertNotEqual(codes[-1], 0, "%s is missing, and nothing was said" % name)
        self.assertTrue(any(code in (2, 3) for code in codes), codes)
        self.assertEqual(codes[-1], 0, codes)
        self.remove(remove)
        self.passes(*command)

    def test_reports(self):
        for name in ("junit", "json"):
            self.check(("run", ".", "--quiet", "--rendering-backend", "none", "--reporter", name + "=r"), ["r"], ["r", "out"])

    def test_streams(self):
        for arguments in (("run", ".", "--reporter", "jsonl=r"), ("run", ".", "--jsonl", "r"),
                          ("run", "w0.walk.yaml", "--log", "r")):
            self.check((*arguments, "--quiet", "--rendering-backend", "none"), [], ["r", "out"])

    def test_records(self):
        self.check(("run", "w0.walk.yaml", "--quiet", "--rendering-backend", "none", "--record", "csv"),
                   ["out/w0/trajectory.csv"], ["out"])

    def test_golden_logs(self):
        self.write("w0.walk.yaml", WALK + "  - log: {golden: true}\n")
        self.check(("run", "w0.walk.yaml", "--quiet", "--rendering-backend", "none", "-u"),
                   ["w0.walk.yaml-snapshots/log.jsonl"], ["w0.walk.yaml-snapshots"])

    def test_results_go_on_where_the_disk_became_full(self):
        command = ("run", ".", "--quiet", "--rendering-backend", "none", "--reporter", "jsonl=r", "-j1")
        self.passes(*command)
        whole = self.read("r")
        for pages in range(6):
            shutil.rmtree(self.path("out"))
            self.run_on_full_disk(pages, *command)
            os.makedirs(self.path("out"), exist_ok=True)
            outcome = self.run_program(*command, "--resume")
            if outcome.code == 0:
                self.assertEqual(self.read("r"), whole)
            else:
                self.assertIn("--resume", outcome.err)  # not even the first line was saved

    def test_merged_reports(self):
        self.passes("run", ".", "--quiet", "--rendering-backend", "none", "--reporter", "jsonl=r.jsonl")
        self.check(("merge-reports", "r.jsonl", "--reporter", "junit=r.xml"), ["r.xml"], ["r.xml"])

    def test_new_projects_and_suggestions(self):
        self.check(("init", "new"), [], ["new"])
        self.check(("info", "room.obj", "--suggest", "s.campus.yaml"), ["s.campus.yaml", "s.walk.yaml"],
                   ["s.campus.yaml", "s.walk.yaml"])

    def test_pictures(self):
        if WITHOUT_RENDERING:
            self.skipTest("this build draws nothing")
        self.check(("snapshot", "small.campus.yaml", "--camera", "start", "-o", "a.png"), ["a.png"], ["a.png"])
        self.passes("snapshot", "small.campus.yaml", "--camera", "top", "-o", "b.png")
        self.write("pictures.walk.yaml", WALK.replace("  - turn", "  - snapshot: {name: there, channels: [depth, ids]}\n  - turn"))
        self.check(("run", "pictures.walk.yaml", "--quiet"), ["out/pictures/there.png"], ["out"])
        self.check(("run", "pictures.walk.yaml", "--quiet", "--every", "1", "--animation", "apng", "--animation", "gif"), ["out/pictures/there.png"],
                   ["out"])


def enter_namespace():
    """Starts this program again where it may mount disks."""
    inside = ["unshare", "--user", "--map-root-user", "--mount"]
    if subprocess.run([*inside, "mount", "-t", "tmpfs", "none", tempfile.gettempdir()], capture_output=True,
                      check=False).returncode != 0:
        print("no disk can be mounted here")
        sys.exit(SKIPPED)
    os.execvp("unshare", [*inside, sys.executable, *sys.argv, "--inside"])


if __name__ == "__main__":
    if "--inside" not in sys.argv:
        enter_namespace()
    sys.argv.remove("--inside")
    if WITHOUT_RENDERING:
        sys.argv.remove("--without-rendering")
    main()
