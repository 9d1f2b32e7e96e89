#!/usr/bin/env python3
"""The README's example works: its files load, and its walk passes on a school built here."""

import os
import re

from program import ProgramCase, main

README = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "README.md")


def slab(name, low, high, first):
    """A box as an OBJ object whose vertices count from `first`."""
    vertices = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    lines = ["o " + name] + ["v %g %g %g" % vertex for vertex in vertices]
    lines += ["f " + " ".join(str(first - 1 + i) for i in face) for face in faces]
    return "\n".join(lines) + "\n"


SCHOOL = (slab("terrain", (-20, -1, -20), (20, 0, 20), 1)
          + slab("library_west", (-4, 0, -7.2), (2.4, 3, -6.8), 9)
          + slab("library_east", (5.6, 0, -7.2), (12, 3, -6.8), 17))


def files_of(text):
    """The YAML blocks that name their file in their first line."""
    return dict(re.findall(r"```yaml\n# (\S+)\n(.*?)```", text, re.DOTALL))


class Readme(ProgramCase):
    def setUp(self):
        super().setUp()
        with open(README, encoding="utf-8") as file:
            self.readme = file.read()
        files = files_of(self.readme)
        self.assertEqual(sorted(files), ["school.campus.yaml", "visit.walk.yaml"])
        for name, text in files.items():
            self.write(name, text.replace("school.glb", "school.obj"))
        self.write("school.obj", SCHOOL)

    def test_the_example_validates(self):
        self.passes("validate", "school.campus.yaml", "visit.walk.yaml")

    def test_the_example_walks(self):
        log = self.passes("run", "visit.walk.yaml", "--rendering-backend", "none").out
        self.assertIn("trigger.enter    library/door", log)
        self.assertIn("result=pass", log)

    def test_the_ten_steps_run_as_written(self):
        for name in ("school.campus.yaml", "visit.walk.yaml"):
            os.remove(self.path(name))
        section = re.search(r"### Bring your own campus\n(.*?)\n\n[A-Z]", self.readme, re.DOTALL).group(1)
        self.assertEqual(re.findall(r"^(\d+)\. ", section, re.MULTILINE), [str(i) for i in range(1, 11)])
        commands = re.findall(r"`campuswalk ([^`]+)`", section)
        self.assertEqual([command.split()[0] for command in commands],
                         ["info", "info", "run", "snapshot", "validate", "run"])
        for command in commands:
            with self.subTest(command=command):
                arguments = command.replace("school.glb", "school.obj").split()
                outcome = self.run_program(*arguments)
                if outcome.code == 3 and "OpenGL" in outcome.err:
                    continue  # a machine that can't draw
                self.assertEqual(outcome.code, 0, outcome.err)

    def events_in(self, lines):
        """`collision.enter .stay .exit` is three events."""
        named = set()
        for first, *others in (re.sub("[`|]", " ", line).split() for line in lines):
            named |= {first} | {first.split(".")[0] + other for other in others}
        return named

    def test_events_are_those_of_the_help(self):
        in_help = self.events_in(re.findall(r"(?m)^  (\w+\.\w+(?: \.\w+)*)  ", self.passes("help", "events").out))
        self.assertEqual(self.events_in(re.findall(r"(?m)^\| (`\w+\.\w+`[^|]*)\|", self.readme)), in_help)

    def test_exit_codes_are_those_of_the_help(self):
        table = self.readme.partition("| exit code |")[2].partition("\n\n")[0]
        in_help = re.findall(r"(?m)^(\d+) ", self.passes("help", "exit-codes").out)
        self.assertEqual(re.findall(r"(?m)^\| (\d+) \|", table), in_help)

    def test_collide_prints_what_the_readme_shows(self):
        arguments, printed = re.search(r"```\n\$ campuswalk (collide .*)\n((?:.*\n)*?)```", self.readme).groups()
        outcome = self.run_program(*arguments.replace("school.glb", "school.obj").split())
        self.assertEqual((outcome.code, outcome.err), (1, ""))
        self.assertEqual(outcome.out, printed.replace("school.glb", "school.obj"))


if __name__ == "__main__":
    main()
