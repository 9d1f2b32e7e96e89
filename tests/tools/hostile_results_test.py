#!/usr/bin/env python3
"""Results that come back from elsewhere, as reports, `last-run.jsonl` or times of shards, may be anybody's."""

import os
import re
import shutil

from program import ProgramCase, main

DEEP = b"[" * 100000 + b"]" * 100000
KEY = {"CAMPUSWALK_RUN_KEY": "0123456789abcdef0123"}


class HostileResults(ProgramCase):
    def setUp(self):
        super().setUp()
        run = self.run_program("run", "short.walk.yaml", "--rendering-backend", "none", "--reporter", "jsonl=r.jsonl",
                               "--output", "out")
        self.assertEqual(run.code, 0, run.err)
        self.header, self.result = self.read("r.jsonl").splitlines(keepends=True)

    def refused(self, code, *arguments, **variables):
        outcome = self.run_program(*arguments, env={**os.environ, **variables})
        self.assert_refused(outcome, code)
        self.assertLess(len(outcome.err), 1000)

    def results_refused(self):
        self.refused("r.jsonl:2:1: error bad-report:", "merge-reports", "r.jsonl", "-q")
        self.refused("r.jsonl:2:1: error bad-report:", "report", "r.jsonl", "-o", "r.html")
        self.refused("r.jsonl:2:1: error no-result:", "replay", "r.jsonl", "--verify")

    def test_deeply_nested_results(self):
        tags = re.compile(rb'"tags":\[[^]]*\]')
        self.assertRegex(self.result, tags)
        for deep in (DEEP, DEEP[:100000], b'{"a":' * 100000):
            self.write("r.jsonl", self.header + tags.sub(b'"tags":' + deep, self.result))
            self.results_refused()

    def test_deeply_nested_headers(self):
        self.write("r.jsonl", self.header.replace(b'"start":', b'"start":' + DEEP + b',"end":') + self.result)
        for key in ({}, KEY):
            self.refused("r.jsonl:1:1: error bad-report:", "merge-reports", "r.jsonl", "-q", **key)

    def test_deeply_nested_last_runs(self):
        unsigned = b'{"code":"%064d",' % 0
        for lines in ([unsigned + b'"campuswalk_last_run":"x"}\n', unsigned + b'"tags":' + DEEP + b"}\n"],
                      [unsigned + b'"campuswalk_last_run":' + DEEP + b"}\n"]):
            shutil.rmtree(self.path("out"), ignore_errors=True)
            self.write("out/last-run.jsonl", b"".join(lines))
            for option in ("--resume=auto", "--last-failed"):
                self.refused("out/last-run.jsonl:%d:1: error bad-last-run:" % len(lines), "run", "short.walk.yaml",
                             option, "--output", "out")

    def test_deeply_nested_times(self):
        self.write("times.jsonl", b'{"id":' + DEEP + b"}\n")
        self.refused("times.jsonl:1:1: error bad-times:", "run", "short.walk.yaml", "--shard=1/2", "--shard-times",
                     "times.jsonl")

    def test_long_lines(self):
        self.write("r.jsonl", self.header + b'{"id":"' + b"x" * (9 << 20) + b'"}\n')
        self.refused("r.jsonl:2:1: error long-line:", "merge-reports", "r.jsonl", "-q")
        self.refused("r.jsonl:2:1: error long-line:", "replay", "r.jsonl")
        self.refused("r.jsonl:2:1: error long-line:", "diff", "r.jsonl", "r.jsonl")

    def test_objects_of_many_members(self):
        """Each name is looked up among all before it: a limit, and not time that grows with the square."""
        members = b",".join(b'"k%d":0' % i for i in range(400_000))
        self.write("r.jsonl", self.header + self.result.rstrip()[:-1] + b"," + members + b"}\n")
        self.results_refused()
        self.refused("r.jsonl:2:1: error bad-report: more than 1000 members", "merge-reports", "r.jsonl", "-q")
        self.refused("r.jsonl:2:1: error bad-times:", "run", "short.walk.yaml", "--shard=1/2", "--shard-times", "r.jsonl")
        self.write("r.jsonl", self.header.rstrip()[:-1] + b"," + members + b"}\n" + self.result)
        self.refused("r.jsonl:1:1: error bad-report:", "merge-reports", "r.jsonl", "-q")
        self.write("out/last-run.jsonl", b'{"code":"%064d","campuswalk_last_run":"x",%s}\n' % (0, members))
        self.refused("out/last-run.jsonl:1:1: error bad-last-run:", "run", "short.walk.yaml", "--last-failed", "--output", "out")

    def test_logs_of_many_members(self):
        self.assertEqual(self.run_program("run", "short.walk.yaml", "--jsonl", "a.jsonl").code, 0)
        header, event, *rest = self.read("a.jsonl").splitlines(keepends=True)
        for name, value in (("b.jsonl", b"0"), ("c.jsonl", b"1")):
            members = b",".join(b'"k%d":%s' % (i, value) for i in range(400_000))
            self.write(name, header + event.rstrip()[:-1] + b"," + members + b"}\n" + b"".join(rest))
        outcome = self.run_program("diff", "b.jsonl", "c.jsonl")
        self.assertEqual(outcome.code, 1)
        self.assertIn("a line that isn't a log's JSON instead of", outcome.out)

    def test_messages_quote_little_of_it(self):
        for line in (b'{"id":"' + b"x" * 100000, b'{"' + b"x" * 100000 + b'":1,"' + b"x" * 100000 + b'":1}',
                     b'{"' + b"x" * 100000 + b'":1}', b"9" * 100000, b'{"id":"' + b"x" * 100000 + b'"}'):
            self.write("r.jsonl", self.header + line + b"\n")
            self.results_refused()

    def test_repeated_keys(self):
        self.write("r.jsonl", self.header.replace(b'"start":', b'"start":"","start":') + self.result)
        self.refused("r.jsonl:1:1: error bad-report: repeated", "merge-reports", "r.jsonl")


if __name__ == "__main__":
    main()
