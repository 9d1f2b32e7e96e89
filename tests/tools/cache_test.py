#!/usr/bin/env python3
"""The cache of models: it never changes what a run prints."""

import os
import shutil
import subprocess
import time

from program import ProgramCase, main


class Cache(ProgramCase):
    def setUp(self):
        super().setUp()
        self.cache = self.path("cache")
        self.environment = dict(os.environ, CAMPUSWALK_CACHE_DIR=self.cache)
        self.environment.pop("CAMPUSWALK_CACHE_SIZE", None)

    def walk(self, *arguments, **variables):
        outcome = self.passes("run", "short.walk.yaml", *arguments, env=dict(self.environment, **variables))
        return outcome.out, outcome.err

    def cached_files(self, stamps=False):
        """Of models; whether there is a stamp, too, depends on how long ago the program was built."""
        names = sorted(os.listdir(self.cache)) if os.path.isdir(self.cache) else []
        return [os.path.join(self.cache, name) for name in names if name.endswith(".stamp.campuswalk") == stamps]

    def models_in(self, folder):
        return len([name for name in os.listdir(self.path(folder)) if ".stamp." not in name])

    def kinds(self):
        return sorted(name.split(".", 1)[1] for name in self.cached_files())

    def test_a_log_is_the_same_with_and_without_the_cache(self):
        without = self.walk("--no-cache")
        self.assertEqual(self.cached_files(), [])
        self.assertIn("popup.open", without[0])
        self.assertEqual(self.walk(), without, "nothing cached yet")
        self.assertEqual(self.kinds(), ["model.campuswalk", "requests.campuswalk", "trees.campuswalk"])
        self.assertEqual(self.walk(), without, "from the cache")

    def test_a_model_that_has_changed_is_read_again(self):
        self.walk()
        self.write("room.obj", self.read("room.obj").decode().replace("o wall", "o fence"))
        outcome = self.run_program("run", "short.walk.yaml", env=self.environment)
        self.assertEqual(outcome.code, 2)
        self.assertRegex(outcome.err, "error no-node: .*'wall'")

    def test_damaged_files_are_replaced(self):
        log = self.walk()
        whole = {name: self.bytes_of(name) for name in self.cached_files()}
        damages = [lambda b: b[:-1], lambda b: b[:40], lambda b: b"", lambda b: b + b"x",
                   lambda b: b[:12] + b"\xff" + b[13:], lambda b: b[:-5] + bytes([b[-5] ^ 1]) + b[-4:],
                   lambda b: b"#!/bin/sh\n" + b]
        for name in whole:
            for damage in damages:
                with open(name, "wb") as file:
                    file.write(damage(whole[name]))
                self.assertEqual(self.walk(), log)
                self.assertEqual(len(self.bytes_of(name)), len(whole[name]))

    def bytes_of(self, name):
        with open(name, "rb") as file:
            return file.read()

    def test_several_runs_may_fill_the_cache_at_once(self):
        log = self.walk("--no-cache")[0]
        runs = [subprocess.Popen([self.program, "run", "short.walk.yaml"], cwd=self.folder, env=self.environment,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                for _ in range(6)]
        for run in runs:
            self.assertEqual(run.communicate(timeout=120)[0].decode(), log)
            self.assertEqual(run.returncode, 0)
        self.assertEqual(self.kinds(), ["model.campuswalk", "requests.campuswalk", "trees.campuswalk"])
        self.assertEqual(self.walk()[0], log)

    def test_a_folder_that_cannot_be_created_is_only_a_warning(self):
        log = self.walk("--no-cache")
        nowhere = self.path("room.obj") + "/cache"
        out, err = self.walk(CAMPUSWALK_CACHE_DIR=nowhere)
        self.assertEqual(out, log[0])
        warning, *rest = err.splitlines()
        self.assertRegex(warning, "^warning cache-unwritable: .*'%s/" % nowhere)
        self.assertEqual(rest, log[1].splitlines(), "reported once, not for each file")

    def test_a_full_disk_is_reported_once_and_the_cache_is_filled_later(self):
        """On a disk of 4 kB in its own mount namespace, which needs no root where the system allows user namespaces."""
        os.mkdir(self.cache)
        script = """mount -t tmpfs -o size=4k,mode=700 full cache || exit 77
            "$0" run short.walk.yaml >full.log 2>full.err || exit 1
            ls cache | grep -v stamp >full.names
            mount -o remount,size=1m cache
            "$0" run short.walk.yaml >roomy.log 2>roomy.err || exit 1
            ls cache | grep -v stamp >roomy.names"""
        log, err = self.walk("--no-cache")
        done = subprocess.run(["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script, self.program],
                              cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=120, check=False)
        if done.returncode == 77 or b"unshare" in done.stderr:
            self.skipTest("no user namespaces here")
        self.assertEqual(done.returncode, 0, done.stderr)
        warning, *rest = self.read("full.err").decode().splitlines()
        self.assertRegex(warning, "^warning cache-unwritable: .*'%s/.*No space left on device" % self.cache)
        self.assertEqual((self.read("full.log").decode(), rest), (log, err.splitlines()))
        self.assertNotIn(b".part", self.read("full.names"))
        self.assertLess(self.read("full.names").count(b".campuswalk\n"), 3)
        self.assertEqual((self.read("roomy.log").decode(), self.read("roomy.err").decode()), (log, err))
        self.assertEqual(self.read("roomy.names").count(b".campuswalk\n"), 3)

    def test_an_unwritable_folder_is_reported_once_by_all_workers(self):
        self.write("again.walk.yaml", self.read("short.walk.yaml"))
        outcome = self.passes("run", ".", "-j2", "--quiet",
                              env=dict(self.environment, CAMPUSWALK_CACHE_DIR=self.path("room.obj") + "/cache"))
        self.assertEqual(outcome.err.count("cache-unwritable"), 1)

    def test_the_folder_comes_from_the_environment(self):
        self.environment.pop("CAMPUSWALK_CACHE_DIR")
        self.walk(XDG_CACHE_HOME=self.path("xdg"))
        self.assertEqual(self.models_in("xdg/campuswalk"), 3)
        self.walk(XDG_CACHE_HOME="", HOME=self.path("home"))
        self.assertEqual(self.models_in("home/.cache/campuswalk"), 3)

    def test_a_cache_in_a_checkout_is_not_used(self):
        """A pull request could bring along its own, with other models."""
        log = self.walk("--no-cache")
        for mark in (".git/HEAD", "walks.config.yaml"):
            self.write("project/" + mark, "workers: 1\n")
            os.makedirs(self.path("project/below"))
            os.symlink(self.path("project/below"), self.path("linked"))
            for folder in (self.path("project/.cache"), self.path("linked/cache")):
                out, err = self.walk(CAMPUSWALK_CACHE_DIR=folder)
                self.assertEqual(out, log[0])
                self.assertRegex(err, "^warning cache-unwritable: .*'project'")
                self.assertFalse(os.path.exists(folder))
            out, err = self.walk(CAMPUSWALK_CACHE_DIR=self.path("project/.cache"), HOME=self.path("project"))
            self.assertEqual((out, err), log, "a home may be a repository")
            shutil.rmtree(self.path("project"))
            os.remove(self.path("linked"))

    def test_a_large_file_is_hashed_once(self):
        """Until it changes, even if its time of modification is set back."""
        self.write("room.obj", self.read("room.obj").decode() + "# padding\n" * 200_000)
        times = (1_000_000_000, 1_000_000_000)
        os.utime(self.path("room.obj"), times)
        log = self.walk()
        before = len(self.cached_files(stamps=True))
        self.assertLessEqual(before, 1, "that of the program: the model has just been written")
        time.sleep(3.1)  # stamps of files that are still being changed would lie
        self.assertEqual(self.walk(), log)
        stamps = self.cached_files(stamps=True)
        self.assertIn(len(stamps), (before + 1, 2))
        self.assertEqual(self.walk(), log)
        self.assertEqual(self.cached_files(stamps=True), stamps)
        self.write("room.obj", self.read("room.obj").decode().replace("o wall", "o fall"))
        os.utime(self.path("room.obj"), times)
        self.assertRegex(self.run_program("run", "short.walk.yaml", env=self.environment).err,
                         "error no-node: .*'wall'")

    def test_a_stamp_that_is_damaged_is_written_again(self):
        self.write("room.obj", self.read("room.obj").decode() + "# padding\n" * 200_000)
        time.sleep(3.1)
        log = self.walk()
        for stamp in self.cached_files(stamps=True):
            whole = self.bytes_of(stamp)
            for damaged in (b"", whole[:-1], whole[:-1] + bytes([whole[-1] ^ 1]), whole + b"x"):
                with open(stamp, "wb") as file:
                    file.write(damaged)
                self.assertEqual(self.walk(), log)
                self.assertEqual(self.bytes_of(stamp), whole)

    def test_the_size_comes_from_the_environment(self):
        self.walk(CAMPUSWALK_CACHE_SIZE="0")
        self.assertEqual(self.cached_files(), [])
        self.walk(CAMPUSWALK_CACHE_SIZE="1M")
        self.assertEqual(len(self.cached_files()), 3)
        for size in ("lots", "-1", "5", "5T", "M", "99999999999999999999G"):
            outcome = self.run_program("run", "short.walk.yaml", env=dict(self.environment, CAMPUSWALK_CACHE_SIZE=size))
            self.assert_refused(outcome, "CAMPUSWALK_CACHE_SIZE: error bad-value: '%s'" % size)

    def test_every_command_that_reads_models_can_bypass_the_cache(self):
        for arguments in (("info", "room.obj"), ("validate", "small.campus.yaml"),
                          ("collide", "--count", "room.obj", "sphere:1", "--pose", "0,50,0")):
            self.passes(*arguments, "--no-cache", env=self.environment)
            self.assertEqual(self.cached_files(), [], arguments)
            self.passes(*arguments, env=self.environment)
            self.assertNotEqual(self.cached_files(), [], arguments)
            for name in self.cached_files():
                os.remove(name)


if __name__ == "__main__":
    main()
