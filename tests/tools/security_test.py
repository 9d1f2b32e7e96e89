#!/usr/bin/env python3
"""What SECURITY.md promises holds: every row of its tables names tests, which are run.

`security_test.py PROGRAM BUILD`. A test is named as `FILE: Class`, `FILE: Class.test_name`, of tests/tools/FILE_test.py, or as
ctest knows it in the folder BUILD, such as `Suite.Name`. Several are separated by `;`.
"""

import importlib
import io
import json
import multiprocessing
import os
import re
import subprocess
import sys
import unittest

from program import main

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
BUILD = ""


def rows():
    """(promise, tests) of each row of the tables under «What is promised»."""
    with open(os.path.join(ROOT, "SECURITY.md"), encoding="utf-8") as file:
        section = re.search(r"## What is promised\n(.*?)\n## ", file.read(), re.DOTALL)[1]
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and cells[0] not in ("promise", "---"):
            yield cells[0], [test.strip(" `") for test in cells[1].split(";")] if len(cells) == 2 else []


def python_tests(name):
    """The tests of `FILE: Class` or `FILE: Class.test_name`; none if there aren't such."""
    file, _, rest = name.partition(": ")
    case, _, method = rest.partition(".")
    module = importlib.import_module(file + "_test")
    found = unittest.defaultTestLoader.loadTestsFromTestCase(getattr(module, case))
    return [test for test in found if method in ("", test._testMethodName)]  # pylint: disable=protected-access


def outcome_of(test):
    """Its id, and what it printed if it didn't pass."""
    output = io.StringIO()
    outcome = unittest.TextTestRunner(stream=output, verbosity=2).run(unittest.TestSuite([test]))
    return test.id(), "" if outcome.wasSuccessful() and outcome.testsRun == 1 else output.getvalue()


class Promises(unittest.TestCase):
    def test_every_promise_names_tests(self):
        promises = list(rows())
        self.assertGreater(len(promises), 20)
        for promise, tests in promises:
            with self.subTest(promise=promise[:60]):
                self.assertTrue(tests and all(tests))
                for test in tests:
                    if ": " in test:
                        self.assertTrue(python_tests(test), test)

    def test_the_tests_of_the_program_pass(self):
        names = sorted({test for _, tests in rows() for test in tests if ": " in test})
        chosen = {test.id(): test for name in names for test in python_tests(name)}
        with multiprocessing.get_context("fork").Pool() as pool:
            outcomes = dict(pool.imap_unordered(outcome_of, chosen.values()))
        self.assertEqual(set(outcomes), set(chosen))
        self.assertFalse("".join(test + "\n" + said for test, said in outcomes.items() if said))
        print("promises: %d tests of the program" % len(outcomes))

    def test_the_tests_of_ctest_pass(self):
        names = sorted({test for _, tests in rows() for test in tests if ": " not in test})
        pattern = "^(%s)$" % "|".join(map(re.escape, names))
        listed = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1", "-R", pattern], capture_output=True, check=True)
        tests = json.loads(listed.stdout)["tests"]
        self.assertEqual(sorted(test["name"] for test in tests), names)
        for test in tests:
            with self.subTest(test=test["name"]):
                done = subprocess.run(test["command"], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    BUILD = sys.argv.pop(2)
    main()
