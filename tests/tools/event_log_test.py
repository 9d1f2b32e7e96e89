#!/usr/bin/env python3
"""The two logs: what they contain, that they agree, and that they are the same every time."""

import json
import os
import re
import signal
import subprocess

from program import WALK, ProgramCase, main

LINE = re.compile(r"^(?P<tick>\d{6,}) +(?P<time>\d+\.\d{6}) (?P<event>[a-z]+\.[a-z]+) +(?P<object>\S+)(?P<rest>.*)$")
FIELD = re.compile(r' (?P<name>[a-z_]+)=(?P<value>"(?:[^"\\]|\\.)*"|\S+)')


def parsed(line):
    """A line of the text log as (event, fields), every value still text."""
    match = LINE.match(line)
    assert match, line
    fields = FIELD.findall(match["rest"])
    written = "".join(f" {name}={value}" for name, value in fields)
    assert match["rest"].strip() == written.strip(), line
    return {"tick": match["tick"], "time": match["time"], "event": match["event"], "object": match["object"],
            **dict(fields)}


def as_text(value, shown):
    """A JSON value as the text log writes it, with the decimals shown there."""
    if isinstance(value, list):
        return ",".join(as_text(each, part) for each, part in zip(value, shown.split(",")))
    if isinstance(value, float):
        return f"{value:.{len(shown.partition('.')[2])}f}"
    if isinstance(value, str) and shown.startswith('"'):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
    return str(value)


class EventLog(ProgramCase):
    """Logs of the small campus' walk and of one that fails."""

    def setUp(self):
        super().setUp()
        self.write("fails.walk.yaml", WALK.replace("walk_to: end", "walk_to: [0, -9]"))

    def logs(self, *walks):
        """The lines of the text log and of the JSON lines."""
        outcome = self.run_program("run", *walks, "--reporter", "log", "--log", "a.log", "--jsonl", "a.jsonl")
        self.assertIn(outcome.code, (0, 1))
        text = self.read("a.log").decode()
        self.assertEqual(text, outcome.out)
        return text.splitlines(), self.read("a.jsonl").decode().splitlines()

    def test_the_log_is_the_same_on_every_instruction_set(self):
        expected = self.passes("run", "short.walk.yaml").out
        for instructions in ("sse42", "avx2", "avx512"):
            with self.subTest(instructions):
                environment = dict(os.environ, CAMPUSWALK_INSTRUCTIONS=instructions)
                outcome = self.run_program("run", "short.walk.yaml", env=environment)
                if outcome.err.startswith(f"CAMPUSWALK_INSTRUCTIONS: error bad-value: '{instructions}'"):
                    self.skipTest(outcome.err)
                self.assertEqual((outcome.code, outcome.out), (0, expected))

    def test_an_unknown_instruction_set_is_refused(self):
        outcome = self.run_program("run", "short.walk.yaml",
                                   env=dict(os.environ, CAMPUSWALK_INSTRUCTIONS="mmx"))
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, "CAMPUSWALK_INSTRUCTIONS: error bad-value: 'mmx' sse42 avx2 avx512")

    def test_both_logs_agree_event_by_event(self):
        text, jsonl = self.logs("short.walk.yaml", "fails.walk.yaml")
        self.assertEqual(len(text), len(jsonl))
        self.assertGreater(len(text), 20)
        for line, other in zip(text, jsonl):
            data = json.loads(other)
            if line.startswith("#"):
                self.assertEqual(line, "# walk-log {walk_log} walk={walk} campus={campus} tps={tps}"
                                 .format(**data))
                continue
            event = parsed(line)
            self.assertEqual(list(event), list(data), line)
            self.assertEqual(int(event["tick"]), data["tick"])
            for name in list(event)[1:]:
                self.assertEqual(event[name], as_text(data[name], event[name]), line)

    def test_times_are_ticks_divided_by_the_rate(self):
        for line in self.logs("short.walk.yaml")[0][1:]:
            event = parsed(line)
            self.assertEqual(event["time"], f"{int(event['tick']) / 60:.6f}")

    def test_events_of_the_short_walk(self):
        events = [parsed(line) for line in self.logs("short.walk.yaml")[0][1:]]
        kinds = [(event["event"], event["object"]) for event in events if not event["event"].endswith(".stay")]
        self.assertEqual(kinds, [
            ("walk.start", "short"), ("ray.enter", "hut/wall"), ("popup.open", "hut"), ("trigger.enter", "gate"),
            ("trigger.exit", "gate"), ("avatar.arrive", "end"), ("popup.close", "hut"), ("ray.exit", "hut/wall"),
            ("walk.end", "short")])
        self.assertEqual(events[2]["title"], '"The Hut"')
        self.assertEqual(events[2]["body"], '"Open 08-22. A wall and nothing behind it."')
        self.assertEqual(int(events[-1]["events"]), len(events) - 2)

    def test_logs_are_the_same_bytes_every_time(self):
        first = self.logs("short.walk.yaml", "fails.walk.yaml")
        self.assertEqual(self.logs("short.walk.yaml", "fails.walk.yaml"), first)

    def test_logs_contain_no_path_of_this_machine(self):
        text, jsonl = self.logs(self.path("short.walk.yaml"), self.path("fails.walk.yaml"))
        for line in text + jsonl:
            self.assertNotIn(self.folder, line)
            self.assertNotIn(".yaml", line)

    def test_logs_contain_no_minus_zero(self):
        for line in self.logs("short.walk.yaml")[0]:
            self.assertNotRegex(line, r"-0\.0*(?![0-9])")

    def test_ticks_and_stays_follow_the_walk(self):
        self.write("short.walk.yaml", WALK.replace("steps:", "sim: {ticks_per_second: 20, stay_every: 0}\nsteps:"))
        text, _ = self.logs("short.walk.yaml")
        self.assertEqual(text[0], "# walk-log 1 walk=short campus=small tps=20")
        stays = [parsed(line) for line in text[1:] if " ray.stay " in line]
        ticks = [int(stay["tick"]) for stay in stays]
        self.assertEqual(ticks, list(range(1, len(ticks) + 1)))

    def test_an_interrupt_leaves_complete_logs(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "wait: 86400"))
        running = subprocess.Popen([self.program, "run", "short.walk.yaml", "--log", "a.log", "--jsonl", "a.jsonl"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   bufsize=0)  # communicate() doesn't see what a buffer read ahead
        seen = [running.stdout.readline() for _ in range(20)]
        running.send_signal(signal.SIGINT)
        rest, err = running.communicate(timeout=60)
        self.assertEqual((running.returncode, err), (130, b"interrupted\n"))
        out = b"".join(seen) + rest
        self.assertTrue(out.endswith(b"\n"))
        self.assertEqual(self.read("a.log"), out)
        jsonl = self.read("a.jsonl").decode().splitlines()
        self.assertEqual(len(jsonl), len(out.splitlines()))
        for line in jsonl:
            json.loads(line)


if __name__ == "__main__":
    main()
