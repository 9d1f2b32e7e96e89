#!/usr/bin/env python3
"""A build without HTML reports says so, and records walks for others that have them."""

import os

from program import ProgramCase, main


class NoHtmlReports(ProgramCase):
    def test_reports_are_refused(self):
        outcome = self.run_program("run", "--reporter", "html=r.html")
        self.assert_refused(outcome, "--reporter: error not-built: CAMPUSWALK_HTML=ON")
        self.assertFalse(os.path.exists(self.path("r.html")))
        self.assert_refused(self.run_program("report", "r.jsonl"), "report: error not-built: CAMPUSWALK_HTML=ON")

    def test_walks_are_recorded(self):
        self.passes("run", "--rendering-backend", "none", "--record", "report")
        self.assertTrue(self.read("out/recordings/short.recording.json").startswith(b'{"campuswalk_recording":1'))


if __name__ == "__main__":
    main()
