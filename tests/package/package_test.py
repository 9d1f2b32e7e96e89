#!/usr/bin/env python3
"""`cmake --install` installs all that find_package(campuswalk) needs: the examples in this folder build against it.

`package_test.py BUILD WORK CMAKE GENERATOR COMPILER CONFIGURATION`: the build to install from, and a folder to work in.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
WALKS = os.path.join(HERE, "walks")
OUTPUT = ["ground 0 overlaps sail 0", "ground 1 overlaps sail 0", "a ray down hits ground 1 at 0.8 of its length"]


class Package(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.installed = os.path.join(cls.work, "installed")
        cls.built = os.path.join(cls.work, "built")
        shutil.rmtree(cls.work, ignore_errors=True)
        install = [cls.cmake, "--install", cls.build, "--prefix", cls.installed, "--component", "collision"]
        if cls.configuration:
            install += ["--config", cls.configuration]
        cls.run_command(*install)

    @classmethod
    def run_command(cls, *command):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, timeout=300)
        text = done.stdout.decode("utf-8", "replace")
        if done.returncode != 0:
            raise AssertionError("%s\nexited with %d:\n%s" % (" ".join(command), done.returncode, text))
        return text

    def installed_files(self):
        for parent, _, files in os.walk(self.installed):
            for name in files:
                yield os.path.relpath(os.path.join(parent, name), self.installed)

    def text_of(self, *names):
        with open(os.path.join(self.installed, *names), encoding="utf-8") as file:
            return file.read()

    def test_the_example_builds_and_runs(self):
        self.run_command(self.cmake, "-S", HERE, "-B", self.built, "-G", self.generator,
                         "-DCMAKE_CXX_COMPILER=" + self.compiler, "-DCMAKE_BUILD_TYPE=" + self.configuration,
                         "-DCMAKE_PREFIX_PATH=" + self.installed, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
        self.run_command(self.cmake, "--build", self.built)
        self.assertEqual(self.run_command(os.path.join(self.built, "two_meshes")).splitlines(), OUTPUT)

        output = self.run_command(os.path.join(self.built, "vectorizing_consumer"))
        self.assertEqual(output, "the consumer adds (x + y) + z, the library x + (y + z)\n")

        with open(os.path.join(self.built, "compile_commands.json"), encoding="utf-8") as file:
            command = json.load(file)[0]["command"]
        self.assertIn(os.path.join(self.installed, "include"), command)
        self.assertNotIn("-Werror", command)
        self.assertNotIn("-Wconversion", command)
        self.assertNotIn("-ffp-contract", command)
        self.assertNotIn("EIGEN", command)

    def test_headers_include_only_each_other_eigen_and_the_standard_library(self):
        include = os.path.join("include", "campuswalk")
        headers = {os.path.relpath(name, include) for name in self.installed_files() if name.endswith(".h")}
        self.assertIn("collision/mesh/mesh_contacts.h", headers)
        for header in headers:
            text = self.text_of(include, header)
            self.assertLessEqual(set(re.findall(r'#include "([^"]+)"', text)), headers, header)
            for other in re.findall(r"#include <([^>]+)>", text):
                self.assertRegex(other, r"^(Eigen/\w+|[a-z_]+)$", header)

    def test_only_headers_libraries_and_cmake_files_are_installed(self):
        files = list(self.installed_files())
        self.assertLessEqual({os.path.splitext(name)[1] for name in files}, {".h", ".cmake", ".a", ".so"})
        self.assertEqual([name for name in files if "kernels" in name or "bullet" in name], [])
        for name in files:
            if name.endswith(".cmake"):
                text = self.text_of(name)
                self.assertNotIn(os.path.dirname(os.path.dirname(HERE)), text, name)
                self.assertNotIn("campuswalk_flags", text, name)


class WalksPackage(unittest.TestCase):
    """The component that runs walks: doctest, its matchers, and a folder that `campuswalk init` made."""

    def test_the_example_builds_and_passes(self):
        installed = os.path.join(Package.work, "installed-engine")
        built = os.path.join(Package.work, "built-walks")
        school = os.path.join(Package.work, "school")
        for folder in (installed, built, school):
            shutil.rmtree(folder, ignore_errors=True)
        for component in ("collision", "engine"):
            install = [Package.cmake, "--install", Package.build, "--prefix", installed, "--component", component]
            Package.run_command(*install, *(["--config", Package.configuration] if Package.configuration else []))
        Package.run_command(os.path.join(Package.build, "campuswalk"), "init", school)
        Package.run_command(Package.cmake, "-S", WALKS, "-B", built, "-G", Package.generator,
                            "-DCMAKE_CXX_COMPILER=" + Package.compiler, "-DCMAKE_BUILD_TYPE=" + Package.configuration,
                            "-DCMAKE_PREFIX_PATH=" + installed)
        Package.run_command(Package.cmake, "--build", built)
        os.environ["SCHOOL"] = school
        output = Package.run_command(os.path.join(built, "school_walks"))
        self.assertIn("2 passed | 0 failed", output)
        with open(os.path.join(school, "walks", "visit.walk.yaml"), "a", encoding="utf-8") as walk:
            walk.write("  - never: popup.open\n")
        failed = subprocess.run([os.path.join(built, "school_walks")], stdout=subprocess.PIPE, check=False, timeout=60)
        self.assertIn(b"1 passed | 1 failed", failed.stdout)
        self.assertEqual(failed.returncode, 1)


class ProgramPackage(unittest.TestCase):
    """The component that users run, wherever its folder is."""

    def setUp(self):
        # Others may have folders of these names above an installation: they are none of its business.
        self.outer = os.path.join(Package.work, "installed program")
        shutil.rmtree(self.outer, ignore_errors=True)
        install = [Package.cmake, "--install", Package.build, "--prefix", os.path.join(self.outer, "first"), "--component",
                   "program"]
        Package.run_command(*install, *(["--config", Package.configuration] if Package.configuration else []))
        os.makedirs(os.path.join(self.outer, "config", "avatars"))
        with open(os.path.join(self.outer, "config", "avatars", "giant.avatar.yaml"), "w", encoding="utf-8") as file:
            file.write("height: 2.5\n")
        self.prefix = os.path.join(self.outer, "moved")
        os.rename(os.path.join(self.outer, "first"), self.prefix)
        self.program = os.path.join(self.prefix, "bin", "campuswalk")

    def test_its_profiles_and_the_demo_are_found(self):
        demo = os.path.join(self.prefix, "share", "campuswalk", "config", "walks", "child-visit.walk.yaml")
        self.assertIn("ok: ", Package.run_command(self.program, "validate", demo))
        outside = tempfile.mkdtemp(prefix="campuswalk-")  # profiles are looked for above a walk: not in these sources
        self.addCleanup(shutil.rmtree, outside, ignore_errors=True)
        school = os.path.join(outside, "school")
        Package.run_command(self.program, "init", school)
        shutil.rmtree(os.path.join(school, "avatars"))
        Package.run_command(self.program, "validate", school)  # whose walks name the profile adult
        walk = os.path.join(school, "walks", "visit.walk.yaml")
        with open(walk, encoding="utf-8") as file:
            text = file.read()
        with open(walk, "w", encoding="utf-8") as file:
            file.write(text.replace("avatar: adult", "avatar: giant"))
        done = subprocess.run([self.program, "validate", walk], stderr=subprocess.PIPE, check=False, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"there is no giant.avatar.yaml", done.stderr)
        self.assertIn(b"child", done.stderr)

    def test_completions_and_schemas_are_beside_it(self):
        share = os.path.join(self.prefix, "share")
        for shell, name in (("bash", "bash-completion/completions/campuswalk"), ("zsh", "zsh/vendor-completions/_campuswalk"),
                            ("fish", "fish/vendor_completions.d/campuswalk.fish")):
            with open(os.path.join(share, name), encoding="utf-8") as file:
                self.assertEqual(file.read(), Package.run_command(self.program, "completion", shell))
        self.assertIn("walk.schema.json", os.listdir(os.path.join(share, "campuswalk", "config", "schema")))
        self.assertNotIn("expectations", os.listdir(os.path.join(share, "campuswalk", "config", "walks")))

    def test_it_names_no_folder_of_the_build(self):
        with open(self.program, "rb") as file:
            self.assertNotIn(Package.build.encode(), file.read())


if __name__ == "__main__":
    Package.build, Package.work, Package.cmake, Package.generator, Package.compiler = sys.argv[1:6]
    Package.configuration = sys.argv[6] if len(sys.argv) > 6 else ""
    unittest.main(argv=sys.argv[:1], verbosity=2)
