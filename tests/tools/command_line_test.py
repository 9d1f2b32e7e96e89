#!/usr/bin/env python3
"""What the command line prints and which exit code it ends with."""

import json
import os
import subprocess

from program import CAMPUS, ROOM, WALK, ProgramCase, main

COMMANDS = ("run", "merge-reports", "validate", "info", "snapshot", "diff", "replay", "collide")


class Help(ProgramCase):
    """--help and --version."""

    def test_help_of_the_program_names_every_command(self):
        for option in ("--help", "-h"):
            outcome = self.passes(option)
            for command in COMMANDS:
                self.assertRegex(outcome.out, rf"(?m)^  {command} ")

    def test_help_of_every_command(self):
        for command in COMMANDS:
            outcome = self.passes(command, "--help")
            self.assertIn(f"Usage: campuswalk {command} ", outcome.out)
            self.assertEqual(outcome.err, "")

    def test_help_of_run_lists_the_exit_codes(self):
        self.assertRegex(self.passes("run", "--help").out, "Exit code: 0 .* 1 .* 2 ")

    def test_version_everywhere(self):
        versions = {self.passes("--version").out}
        versions |= {self.passes(command, "--version").out for command in COMMANDS}
        self.assertEqual(len(versions), 1)
        self.assertRegex(versions.pop(), r"^campuswalk \d+\.\d+\.\d+\n$")


class Usage(ProgramCase):
    """Bad usage ends with 2, a line that says why, and one that points to the help."""

    def refused(self, arguments, *, expected, command=""):
        self.assert_bad_usage(self.run_program(*arguments), f"campuswalk {command}".strip(), expected)

    def test_unknown_commands_are_refused(self):
        self.refused([],
                     expected="init validate run merge-reports diff imgdiff replay info snapshot collide completion help")
        self.refused(["rum"], expected="'rum' 'run'")
        self.refused(["dance"], expected="'dance'")
        self.refused(["--verbose"], expected="'--verbose'")

    def test_missing_and_unknown_arguments_are_refused(self):
        for arguments in ((), ("a.jsonl", "--artifacts", ".")):
            outcome = self.run_program("merge-reports", *arguments)
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assert_diagnostics(outcome.err_lines, "REPORT: error bad-value: --artifacts")
        self.refused(["validate"], expected="PATH", command="validate ")
        self.refused(["info"], expected="SCENE", command="info ")
        self.refused(["snapshot", "-o", "a.png"], expected="CAMPUS", command="snapshot ")
        self.refused(["snapshot", "a.campus.yaml"], expected="--output", command="snapshot ")
        self.refused(["run", "--zoom", "a"], expected="--zoom", command="run ")
        self.refused(["run", "--tags=a"], expected="--tags=a '--tag'", command="run ")
        self.refused(["info", "a.obj", "b.obj"], expected="b.obj", command="info ")
        self.refused(["run", "a", "--log"], expected="--log FILE", command="run ")

    def test_values_out_of_range_are_refused(self):
        self.refused(["run", "a", "--rendering-backend", "gpu"],
                     expected="--rendering-backend 'gpu' auto|egl|none|osmesa", command="run ")
        self.refused(["info", "a", "--up", "x"], expected="--up 'x' y|z", command="info ")
        self.refused(["snapshot", "a", "-o", "b", "--width", "8193"],
                     expected="--width 8193 16 8192", command="snapshot ")


class Run(ProgramCase):
    """Exit codes and verdicts of `run`."""

    def test_a_passing_walk_exits_with_0(self):
        outcome = self.passes("run", "short.walk.yaml")
        self.assertEqual(outcome.lines[0], "# walk-log 1 walk=short campus=small tps=60")
        self.assertIn(" result=pass ", outcome.lines[-1])
        self.assertRegex(outcome.err, r"^short: pass after \d+\.\d s and \d+\.\d m\n$")

    def test_quiet(self):
        self.assertEqual(self.passes("run", "-q", "short.walk.yaml").out, "")

    def test_failed_expectations(self):
        self.write("short.walk.yaml", WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")
                   + "  - count: {event: trigger.enter, equals: 3}\n  - reaches: {place: start, within: 0.5}\n"
                   + "  - reaches: end\n")
        outcome = self.run_program("run", "short.walk.yaml")
        self.assertEqual(outcome.code, 1)
        starts = [line.split(": ")[:2] for line in outcome.err_lines]
        self.assertEqual(starts[:2], [["short.walk.yaml:9:12", "error never"], ["short.walk.yaml:10:12", "error count"]])
        self.assertRegex(outcome.err_lines[-1], r"^short: FAIL after ")
        pictures = [line.partition(": ")[2] for line in outcome.err_lines[2:-1]]
        names = [f"{number}{view}" for number in ("", "2-") for view in ("eyes", "beside", "above")]
        self.assertIn(pictures, ([], [f"out/short/failure-{name}.png" for name in names]))
        for name in pictures:  # none where nothing can be drawn
            self.assertTrue(self.read(name).startswith(b"\x89PNG"))
        self.assertRegex(outcome.err_lines[1], "'trigger.enter' .* 3")
        failures = [line for line in outcome.lines if " expect.fail " in line]
        self.assertEqual(len(failures), 2)
        self.assertIn(" line=9 ", failures[0])
        self.assertIn(" line=10 ", failures[1])
        self.assertIn(" result=fail ", outcome.lines[-1])

    def test_blocked_walk(self):
        self.write("short.walk.yaml", WALK.replace("walk_to: end", "walk_to: [0, -9]"))
        outcome = self.run_program("run", "-q", "short.walk.yaml")
        self.assertEqual(outcome.code, 1)
        self.assert_diagnostics(outcome.err_lines[:1], "short.walk.yaml:5:14: error blocked: 0,-9 hut/wall")

    def test_one_bad_walk_among_several(self):
        self.write("bad.walk.yaml", WALK.replace("walk_to: end", "walk_to: nowhere"))
        self.write("last.walk.yaml", WALK)
        outcome = self.run_program("run", "--reporter", "log", "short.walk.yaml", "bad.walk.yaml", "last.walk.yaml")
        self.assertEqual(outcome.code, 2)
        self.assert_diagnostics(outcome.err_lines[:1], "bad.walk.yaml:5:14: error unknown-name: 'nowhere' end, start")
        self.assertEqual([line.split()[3] for line in outcome.lines if line.startswith("#")],
                         ["walk=last", "walk=short"])

    def test_failed_walk_among_several(self):
        self.write("fails.walk.yaml", WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut"))
        outcome = self.run_program("run", "-q", "fails.walk.yaml", "short.walk.yaml")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.err_lines[-1], "^short: pass ")

    def test_two_walks_of_one_name(self):
        self.write("walks/short.walk.yaml", WALK.replace("small.campus", "../small.campus"))
        outcome = self.passes("run", "-q", "short.walk.yaml", "walks/short.walk.yaml")
        self.assertEqual(len(outcome.err_lines), 2)

    def test_from_another_folder(self):
        here = self.passes("run", "short.walk.yaml").out
        self.assertEqual(self.passes("run", "../short.walk.yaml", cwd=self.path("avatars")).out, here)
        self.assertEqual(self.passes("run", self.path("short.walk.yaml"), cwd="/").out, here)

    def test_output_folders_are_made(self):
        self.passes("run", "-q", "short.walk.yaml", "--log", "logs/new/a.log")
        self.assertIn("walk.end", self.read("logs/new/a.log").decode())

    def test_nothing_but_the_logs_is_written(self):
        before = self.contents()
        self.passes("run", "short.walk.yaml")
        self.assertEqual(self.contents(), before)


class Validate(ProgramCase):
    """`validate`."""

    def test_good_files(self):
        outcome = self.passes("validate", "short.walk.yaml", "small.campus.yaml", "avatars/adult.avatar.yaml")
        self.assertEqual(outcome.lines, [
            "short.walk.yaml: ok: 3 steps, 2 expectations, on small (1 building, 3 objects, 1 spawn, 1 place)",
            "small.campus.yaml: ok: 1 building, 3 objects, 1 spawn, 1 place",
            "avatars/adult.avatar.yaml: ok: an avatar"])

    def test_bad_files(self):
        self.write("small.campus.yaml", CAMPUS.replace("[0, 0, 5]", "[0, 0]"))
        self.write("avatars/adult.avatar.yaml", "heigth: 1.8\n")
        outcome = self.run_program("validate", "avatars/adult.avatar.yaml", "small.campus.yaml", "room.obj", "none")
        self.assertEqual(outcome.out, "")
        self.assert_refused(
            outcome,
            "avatars/adult.avatar.yaml:1:1: error unknown-key: 'heigth' 'height'",
            "small.campus.yaml:14:15: error wrong-type: 'at'",
            "room.obj: error file-name: NAME.walk.yaml NAME.campus.yaml NAME.avatar.yaml NAME.light.yaml NAME.steps.yaml",
            "none: error missing-file:")

    def test_the_others_are_still_checked(self):
        outcome = self.run_program("validate", "none.walk.yaml", "short.walk.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertEqual(len(outcome.lines), 1)


class Info(ProgramCase):
    """`info`."""

    def test_json(self):
        found = json.loads(self.passes("info", "room.obj", "--json").out)
        for key in ("meshes", "triangles", "bounds", "materials", "warnings"):
            self.assertIn(key, found)
        self.assertEqual(found["meshes"], 2)
        self.assertEqual(found["triangles"], 14)
        self.assertEqual(found["bounds"], {"min": [-10, 0, -10], "max": [10, 3, 10]})
        self.assertEqual([node["name"] for node in found["nodes"]], ["room.obj", "floor", "wall"])
        self.assertEqual(sum(material["triangles"] for material in found["materials"]), 14)
        self.assertEqual(found["warnings"], [])

    def test_units_and_axes(self):
        found = json.loads(self.passes("info", "room.obj", "--json", "--up", "z", "--scale", "0.5").out)
        self.assertEqual(found["bounds"], {"min": [-5, -5, -1.5], "max": [5, 5, 0]})

    def test_text(self):
        outcome = self.passes("info", "room.obj")
        self.assertIn("triangles  14", outcome.lines)
        self.assertIn("size       20.000 x 3.000 x 20.000 m, from -10.000,0.000,-10.000 to 10.000,3.000,10.000",
                      outcome.lines)
        self.assertIn("warnings   0", outcome.lines)

    def test_model_lints(self):
        self.write("odd.obj", "mtllib none.mtl\n" + ROOM)
        found = json.loads(self.passes("info", "odd.obj", "--json").out)
        [warning] = found["warnings"]
        self.assertEqual(set(warning), {"code", "message"})
        self.assertEqual(warning["code"], "missing-materials")
        self.assertRegex(warning["message"], "^odd.obj: .*'none.mtl'")

    def test_files_that_are_not_models_are_refused(self):
        for name, expected in (("none.obj", "none.obj: error missing-file: 'none.obj'"),
                               ("avatars", "avatars: error missing-file: 'avatars'")):
            outcome = self.run_program("info", name)
            self.assertEqual(outcome.out, "")
            self.assert_refused(outcome, expected)
        outcome = self.run_program("info", "short.walk.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertRegex(outcome.err, "^short.walk.yaml: error bad-model: 'short.walk.yaml'")


class StandardOutput(ProgramCase):
    """A standard output that can't be written is an error while running."""

    COMMANDS = (("run", "short.walk.yaml"), ("validate", "short.walk.yaml"), ("info", "room.obj"), ("--help",),
                ("--version",))

    def test_full_disk(self):
        for arguments in self.COMMANDS:
            with open("/dev/full", "wb") as full:
                outcome = self.run_program(*arguments, stdout=full)
            self.assert_refused(outcome, "error: standard output", code=3)

    def test_a_closed_standard_output_is_an_error(self):
        for arguments in self.COMMANDS:
            outcome = self.run_program(*arguments, stdout=None, preexec_fn=lambda: os.close(1))
            self.assert_refused(outcome, "error: standard output", code=3)

    def test_quiet_run_needs_none(self):
        outcome = self.run_program("run", "-q", "short.walk.yaml", "--log", "a.log", stdout=None,
                                   preexec_fn=lambda: os.close(1))
        self.assertEqual(outcome.code, 0)
        self.assertIn("walk.end", self.read("a.log").decode())

    def test_reader_that_goes_away(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "wait: 86400"))  # ends early or not at all
        done = subprocess.Popen([self.program, "run", "short.walk.yaml"], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)
        self.addCleanup(done.stderr.close)
        self.assertTrue(done.stdout.readline().startswith(b"# walk-log 1"))
        done.stdout.close()
        self.assertEqual(done.stderr.read(), b"")
        self.assertEqual(done.wait(timeout=60), 3)

    def test_a_reader_that_was_never_there(self):
        for arguments in self.COMMANDS:
            reader, writer = os.pipe()
            os.close(reader)
            outcome = self.run_program(*arguments, stdout=writer)
            os.close(writer)
            self.assertEqual((outcome.code, outcome.err), (3, ""), arguments)


if __name__ == "__main__":
    main()
