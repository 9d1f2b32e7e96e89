"""Runs the campuswalk program on a small campus in a temporary folder. Needs only Python's standard library."""

import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

ROOM = """\
o floor
v -10 0 -10
v 10 0 -10
v 10 0 10
v -10 0 10
f 1 4 3
f 1 3 2
o wall
v -1 0 -4
v 1 0 -4
v 1 3 -4
v -1 3 -4
v -1 0 -5
v 1 0 -5
v 1 3 -5
v -1 3 -5
f 5 6 7
f 5 7 8
f 10 9 12
f 10 12 11
f 9 5 8
f 9 8 12
f 6 10 11
f 6 11 7
f 8 7 11
f 8 11 12
f 5 9 10
f 5 10 6
"""

CAMPUS = """\
scenes:
  - file: room.obj
buildings:
  - id: hut
    title: The Hut
    nodes: wall
    hours: "08-22"
    text: A wall and nothing behind it.
colliders:
  - {id: ground, nodes: floor, shape: mesh, mode: solid}
  - {id: hut/wall, building: hut, shape: mesh, mode: [solid, ray]}
  - {id: gate, shape: box, center: [0, 1, 0], size: [2, 2, 2], mode: trigger}
spawns:
  start: {at: [0, 0, 5]}
places:
  end: [0, 0, -2]
"""

WALK = """\
campus: small.campus.yaml
avatar: adult
steps:
  - spawn: start
  - walk_to: end
  - turn: 180
expect:
  - sequence: ["ray.enter hut/wall", "popup.open hut", "trigger.enter gate", "popup.close hut"]
  - never: "collision.enter hut/wall"
"""

FILES = {
    "room.obj": ROOM,
    "small.campus.yaml": CAMPUS,
    "short.walk.yaml": WALK,
    "avatars/adult.avatar.yaml": "height: 1.8\nradius: 0.3\n",
}

SKIPPED = 77  # ctest's SKIP_RETURN_CODE

# What changes which walks run, or what they may write; a test that is about one of these sets it itself.
STEERING_VARIABLES = ("CI", "CI_PROJECT_DIR", "GITHUB_WORKSPACE", "CAMPUSWALK_SHARD_INDEX", "CAMPUSWALK_SHARD_COUNT", "TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS",
                      "SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX")

HEAD = re.compile(r"(?:\S.*?: )?(?:error|warning)(?: [a-z-]+)?: ?")


def resembles(line, expected):
    """Whether a diagnostic has the place, severity and code of `expected`, and a sentence with its names in this order.

    `expected` is such as "a.walk.yaml:5:14: error unknown-name: 'nowhere' 'end'": the sentence is free.
    """
    head = HEAD.match(expected)[0].rstrip() + " "
    if not line.startswith(head) or not line[len(head):].strip():
        return False
    at = len(head)
    for name in re.findall(r"'[^']*'|\S+", expected[len(head):]):
        at = line.find(name, at)
        if at < 0:
            return False
        at += len(name)
    return True


class Outcome:
    """The exit code and the output of a run of the program."""

    def __init__(self, done):
        self.code = done.returncode
        self.out = done.stdout.decode("utf-8")
        self.err = done.stderr.decode("utf-8")

    @property
    def lines(self):
        return self.out.splitlines()

    @property
    def err_lines(self):
        return self.err.splitlines()


def png(width, height, rows, color_type=2):
    """A PNG file of 8 bits a channel. Each row starts with the byte of its filter, which is 0."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    packer = zlib.compressobj(1)
    packed = b"".join(map(packer.compress, rows)) + packer.flush()
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, color_type, 0, 0, 0)) +
            chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def plain_png(width, height, color):
    """A picture of one color."""
    return png(width, height, (b"\0" + bytes(color) * width for _ in range(height)))


class ProgramCase(unittest.TestCase):
    """Every test starts in a fresh folder with FILES."""

    maxDiff = None
    program = ""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="campuswalk-")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        for name, text in FILES.items():
            self.write(name, text)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        """Text or bytes."""
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "wb") as file:
            file.write(content.encode("utf-8") if isinstance(content, str) else content)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def contents(self):
        """Every file and folder, with the files' bytes."""
        found = {}
        for parent, folders, files in os.walk(self.folder):
            for name in folders:
                found[os.path.relpath(os.path.join(parent, name), self.folder)] = None
            for name in files:
                relative = os.path.relpath(os.path.join(parent, name), self.folder)
                found[relative] = self.read(relative)
        return found

    def run_program(self, *arguments, longest=600, **options):
        """`longest`, in seconds: under sanitizers the import of a quarter of a town takes three minutes."""
        options.setdefault("cwd", self.folder)
        options.setdefault("stdout", subprocess.PIPE)
        done = subprocess.run([self.program, *arguments], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              check=False, timeout=longest, **options)
        done.stdout = done.stdout or b""
        return Outcome(done)

    def assert_diagnostics(self, lines, *expected):
        """One line for each expected diagnostic; see resembles()."""
        self.assertEqual(len(lines), len(expected), lines)
        for line, each in zip(lines, expected):
            self.assertTrue(resembles(line, each), "%s\ndoesn't resemble\n%s" % (line, each))

    def assert_refused(self, outcome, *expected, code=2):
        """The exit code, and these diagnostics on standard error."""
        self.assertEqual(outcome.code, code, outcome.err)
        self.assert_diagnostics(outcome.err_lines, *expected)

    def assert_bad_usage(self, outcome, command, expected):
        """One error without a code that has these names in this order, and where to read more."""
        self.assertEqual((outcome.code, outcome.out, len(outcome.err_lines)), (2, "", 2), outcome.err)
        self.assert_diagnostics(outcome.err_lines[:1], "error: " + expected)
        self.assertTrue(outcome.err_lines[1].endswith(f"{command} --help"), outcome.err)

    def passes(self, *arguments, **options):
        """Runs it and expects exit code 0."""
        outcome = self.run_program(*arguments, **options)
        self.assertEqual((outcome.code, outcome.err if outcome.code else ""), (0, ""))
        return outcome


class CheckoutCase(ProgramCase):
    """The folder is a checkout in one of its own; beside it is what must stay untouched."""

    def setUp(self):
        super().setUp()
        self.outer = self.folder
        self.folder = os.path.join(self.outer, "checkout")
        inside = os.listdir(self.outer)
        os.makedirs(self.path(".git"))
        for name in inside:
            os.rename(os.path.join(self.outer, name), self.path(name))

    def outer_contents(self):
        """Every file's bytes and every link's target."""
        found = {}
        for parent, _, files in os.walk(self.outer):
            for path in (os.path.join(parent, name) for name in files):
                if os.path.islink(path):
                    found[path] = os.readlink(path)
                else:
                    with open(path, "rb") as file:
                        found[path] = file.read()
        return found


def main():
    """`TEST.py PROGRAM [unittest's arguments]`."""
    ProgramCase.program = os.path.abspath(sys.argv.pop(1))
    for name in STEERING_VARIABLES:
        os.environ.pop(name, None)
    with tempfile.TemporaryDirectory(prefix="campuswalk-cache-") as cache:
        os.environ["CAMPUSWALK_CACHE_DIR"] = cache  # not the user's own
        os.environ["XDG_STATE_HOME"] = os.path.join(cache, "state")
        unittest.main(verbosity=2)
