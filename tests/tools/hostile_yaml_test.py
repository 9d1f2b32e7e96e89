#!/usr/bin/env python3
"""Malicious YAML is refused quickly and with a bounded amount of memory, in every kind of file."""

import resource
import time

import yaml

from program import CAMPUS, WALK, ProgramCase, main

MEMORY = 600 << 20  # bytes of address space, libraries included
LARGE = 1_900_000  # bytes, below the largest size that is read
TIMES = 5.0  # as much processor time as libyaml takes for a large file; an idle machine takes half of it
RUNS = 4  # of which the least counts: other programs on the same core make it take longer

# The file that is replaced, and the command that reads it.
TARGETS = [
    ("small.campus.yaml", ("run", "short.walk.yaml")),
    ("short.walk.yaml", ("run", "short.walk.yaml")),
    ("avatars/adult.avatar.yaml", ("run", "short.walk.yaml")),
    ("lap.steps.yaml", ("run", "laps.walk.yaml")),
    ("lap.steps.yaml", ("validate", "lap.steps.yaml")),
]


def bomb(levels, width):
    """Anchors whose aliases double, triple, … at each level."""
    lines = ["a0: &a0 [x, x]"]
    for level in range(1, levels):
        lines.append("a%d: &a%d [%s]" % (level, level, ", ".join(["*a%d" % (level - 1)] * width)))
    return "\n".join(lines) + "\n"


# Slow for the parser, so only tried on one kind of file.
def large(size):
    """`size` is in bytes, below the largest size that is read."""
    return {
        "many anchors": "".join("k%d: &k%d 1\n" % (i, i) for i in range(size // 18)),
        "many keys": "".join("k%d: 1\n" % i for i in range(size // 11)),
        "the same key": "k: 1\n" * (size // 5),
        "many values": "- 1\n" * (size // 4),
        "one long line": "a: " + "x" * (size - 4),
        "comments": "#\n" * (size // 2),
        "an unclosed quote": "a: \"" + "x\n" * (size // 2 - 4),
        "deep braces": "{a: " * (size // 4),
        "too large": "a: b\n" * (50_000_000 // 5),
    }


def dense(size):
    """What the parser would keep in memory as a whole before it reports any of it."""
    return {
        "a list in a line": "[" + "a," * (size // 2) + "]",
        "lists in a list": "[\n" + "[]," * (size // 3),
        "lists side by side": "[" + "[]" * (size // 2),
        "a map in a line": "{" + "a: b," * (size // 5) + "}",
        "anchors": "[" + "&a " * (size // 3),
        "tags": "[" + "!a " * (size // 3),
        "aliases": "[" + "*a " * (size // 3),
        "keys": "[" + "? " * (size // 2),
        "values": "[" + ": " * (size // 2),
    }


SMALL = {
    "deep brackets": "a: " + "[" * 20_000,
    "deep indentation": "".join(" " * depth + "a:\n" for depth in range(500)),
    "deep dashes": "- " * 20_000 + "a",
    "nested complex keys": "? " * 20_000,
    "a billion laughs": bomb(40, 9),
    "a billion laughs in a list": bomb(12, 300),
    "an anchor that names itself": "a: &a\n  b: *a\n",
    "binary": bytes(range(256)) * 100,
    "an ELF file": b"\x7fELF\x02\x01\x01\x00" + b"\x00" * 4000,
    "UTF-16": "steps: []\n".encode("utf-16"),
    "bad UTF-8": b"a: caf\xe9\n",
    "UTF-8 cut short": b"a: \xf0\x9f\x8c",
    "overlong UTF-8": b"a: \xc0\xaf\n",
    "NUL": b"a: b\x00c\n",
    "lone carriage returns": b"a: 1\rb: 2\r",
    "tabs": "a:\n\tb: 1\n",
    "a byte order mark alone": b"\xef\xbb\xbf",
    "nothing": b"",
    "duplicate keys": "steps: []\nsteps: []\n",
    "a directive": "%YAML 1.2\n---\na: 1\n",
    "two documents": "a: 1\n---\nb: 1\n",
    "tags": "!!python/object/apply:os.system ['true']\n",
    "a merge key": "a: &a {b: 1}\n<<: *a\n",
}

NUMBERS = ["1e400", "-1e400", "1" + "0" * 100_000, "1e-400000", "." * 1000, "0x7fffffffffffffff", "1e", "--1", ".inf",
           "-.inf", ".nan", "9" * 400, "1_000", "0o17", "12:30:45"]


class HostileYaml(ProgramCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        start = time.process_time()
        for _ in yaml.parse("- 1\n" * (LARGE // 4), Loader=yaml.CLoader):
            pass
        cls.most_seconds = TIMES * (time.process_time() - start)

    def setUp(self):
        super().setUp()
        with open(self.program, "rb") as file:
            self.is_sanitized = b"__asan_init" in file.read()
        self.write("lap.steps.yaml", "steps: [{wait: 1}]\n")
        self.write("laps.walk.yaml", WALK.replace("turn: 180", "include: lap.steps.yaml"))

    def refuses(self, arguments, what):
        """Ends with 2 and short diagnostics, in time, with little memory."""
        seconds, outcome = self.run_timed(arguments)
        for _ in range(RUNS - 1):
            if seconds >= self.most_seconds:
                seconds = min(seconds, self.run_timed(arguments)[0])
        self.assertEqual((outcome.code, outcome.out), (2, ""), (what, outcome.err[:300]))
        self.assertRegex(outcome.err, r"^\S+: error [a-z-]+: ", what)
        self.assertLess(len(outcome.err), 200_000, what)
        if not self.is_sanitized:
            self.assertLess(seconds, self.most_seconds, what)

    def run_timed(self, arguments):
        before = self.processor_seconds()
        outcome = self.run_program(*arguments, preexec_fn=self.limit_memory)
        return self.processor_seconds() - before, outcome

    @staticmethod
    def processor_seconds():
        """Of all child processes, so that other programs don't count."""
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    def limit_memory(self):
        if not self.is_sanitized:  # a sanitizer reserves terabytes
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    def test_small_files_are_refused(self):
        for name, arguments in TARGETS:
            original = self.read(name)
            for what, content in SMALL.items():
                with self.subTest(what, file=name, command=arguments[0]):
                    self.write(name, content)
                    self.refuses(arguments, what)
            self.write(name, original)

    def test_large_files_are_refused(self):
        for what, content in large(LARGE // 10 if self.is_sanitized else LARGE).items():
            with self.subTest(what):
                self.write("large.avatar.yaml", content)
                self.refuses(("validate", "large.avatar.yaml"), what)

    def test_long_texts_that_aliases_repeat_are_refused(self):
        """Each would be copied: two hundred names of a megabyte."""
        placements = "{name: &a " + "n" * 1_000_000 + "}" + ", {name: *a}" * 200
        self.write("long.campus.yaml", "scenes: [{file: room.obj, placements: [" + placements + "]}]\ncolliders: []\n")
        outcome = self.run_program("validate", "long.campus.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertIn("long.campus.yaml:1:39: error too-large: more than a million values", outcome.err)

    def test_dense_files_are_refused(self):
        for size in (7_900_000, 700_000):
            for what, content in dense(size).items():
                with self.subTest(what, size=size):
                    self.write("dense.avatar.yaml", content)
                    self.refuses(("validate", "dense.avatar.yaml"), what)

    def test_hostile_numbers_are_refused(self):
        for number in NUMBERS:
            with self.subTest(number=number[:30]):
                self.write("short.walk.yaml", WALK.replace("turn: 180", "turn: " + number))
                self.refuses(("run", "short.walk.yaml"), number[:30])
                self.write("short.walk.yaml", WALK)
                self.write("small.campus.yaml", CAMPUS.replace("[0, 0, 5]", "[0, 0, %s]" % number))
                self.refuses(("run", "short.walk.yaml"), number[:30])
                self.write("small.campus.yaml", CAMPUS)
                self.write("avatars/adult.avatar.yaml", "height: %s\n" % number)
                self.refuses(("run", "short.walk.yaml"), number[:30])
                self.write("avatars/adult.avatar.yaml", "height: 1.8\n")

    def test_byte_order_marks_and_windows_line_ends_are_accepted(self):
        self.write("short.walk.yaml", "\ufeff" + WALK.replace("\n", "\r\n"))
        self.passes("run", "-q", "short.walk.yaml")


if __name__ == "__main__":
    main()
