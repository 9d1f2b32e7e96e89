#!/usr/bin/env python3
"""The layer check finds each kind of violation, says exactly where, and passes this checkout."""

import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tools"))
from check_layers import table  # pylint: disable=wrong-import-position
HEADER = "#pragma once\n"


def run_check(root):
    """(exit code, lines but the last, last line)."""
    done = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "check-layers"), "--root", root],
                          capture_output=True, text=True, check=False)
    assert not done.stderr, done.stderr
    *diagnostics, summary = done.stdout.splitlines()
    return done.returncode, diagnostics, summary


class CheckLayers(unittest.TestCase):
    """Each test checks a small tree."""

    def diagnostics(self, files):
        """What the check prints for a tree of these files; its exit code must agree."""
        with tempfile.TemporaryDirectory() as root:
            for name, text in files.items():
                path = os.path.join(root, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            code, diagnostics, _ = run_check(root)
        self.assertEqual(code, 1 if diagnostics else 0)
        return diagnostics

    def finds(self, files, *expected):
        """The check finds these and nothing else."""
        self.assertEqual(self.diagnostics(files), list(expected))

    def test_this_checkout_is_in_order(self):
        code, diagnostics, summary = run_check(ROOT)
        self.assertEqual((code, diagnostics), (0, []))
        self.assertRegex(summary, r"^layers: \d{3,} C\+\+ files, \d+ build files, all in order$")

    def test_an_empty_tree_is_in_order(self):
        self.finds({})

    def test_the_table_lists_folders_that_depend_one_way(self):
        for place in set(table.PROJECT).union(*table.THIRD_PARTY.values(), *table.PROJECT.values()) - {table.ANYWHERE}:
            self.assertNotRegex(place, r"\.\w+$")
            self.assertTrue(os.path.isdir(os.path.join(ROOT, place)), place)
        places = [place for place in table.PROJECT if table.ANYWHERE not in table.PROJECT[place]]
        below = {place: {other for other in places if other != place
                         and table.is_in(other, [place] + table.PROJECT[place])} for place in places}
        while below:
            lowest = {place for place, others in below.items() if not others}
            self.assertTrue(lowest, "these depend on one another: %s" % sorted(below))
            below = {place: others - lowest for place, others in below.items() if place not in lowest}

    def test_a_lower_layer_may_not_include_a_higher_one(self):
        [diagnostic] = self.diagnostics({"scene/campus/campus.h": HEADER,
                                       "collision/world/world.cpp": '\n  #include "scene/campus/campus.h"\n'})
        self.assertTrue(diagnostic.startswith(
            'collision/world/world.cpp:2:12: error layer: collision/world may not include "scene/campus/campus.h"; '
            'it may include collision/world, '), diagnostic)

    def test_the_core_may_not_include_the_renderer(self):
        [diagnostic] = self.diagnostics({"engine/render/overlay/canvas.h": HEADER,
                                       "engine/simulation/simulation.cpp": '#include "engine/render/overlay/canvas.h"\n'})
        self.assertTrue(diagnostic.startswith(
            'engine/simulation/simulation.cpp:1:10: error layer: engine/simulation may not include "engine/render/overlay/canvas.h"; '), diagnostic)

    def test_the_core_may_include_the_observer_interface_only(self):
        [diagnostic] = self.diagnostics({
            "engine/record/observer.h": HEADER, "engine/observers/text_log.h": HEADER,
            "engine/simulation/run_walk.cpp": '#include "engine/record/observer.h"\n#include "engine/observers/text_log.h"\n'})
        self.assertTrue(diagnostic.startswith(
            'engine/simulation/run_walk.cpp:2:10: error layer: engine/simulation may not include "engine/observers/text_log.h"; '), diagnostic)

    def test_the_product_may_not_include_tests(self):
        [diagnostic] = self.diagnostics({"tests/support/village.h": HEADER,
                                       "scene/import/x.cpp": '#include "tests/support/village.h"\n'})
        self.assertTrue(diagnostic.startswith(
            'scene/import/x.cpp:1:10: error layer: scene/import may not include "tests/support/village.h"; '), diagnostic)

    def test_the_oracle_may_not_include_the_mover(self):
        [diagnostic] = self.diagnostics({"collision/mover/mover.h": HEADER,
                                       "tests/support/penetration_oracle.cpp": '#include "collision/mover/mover.h"\n'})
        self.assertTrue(diagnostic.startswith(
            "tests/support/penetration_oracle.cpp:1:10: error layer: tests/support/penetration_oracle.cpp "
            'may not include "collision/mover/mover.h"; '), diagnostic)

    def test_bullets_narrow_phase_is_for_tests_and_peers(self):
        narrow = "#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>\n"
        message = "<BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h> may be included in tests, " \
                  "tools/campuswalk_bench/peers only"
        self.finds({"collision/world/bullet_broad_phase.cpp": narrow, "collision/world/cast.cpp": narrow,
                    "tests/collision/bullet_peer.cpp": narrow},
                   "collision/world/bullet_broad_phase.cpp:1:10: error third-party: " + message,
                   "collision/world/cast.cpp:1:10: error third-party: " + message)

    def test_bullets_broad_phase_has_one_place(self):
        broad = "#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>\n"
        self.finds({"collision/world/bullet_broad_phase.cpp": broad, "collision/mover/mover.h": HEADER + broad},
                   "collision/mover/mover.h:2:10: error third-party: "
                   "<BulletCollision/BroadphaseCollision/btDbvtBroadphase.h> may be included in "
                   "collision/world, tools/campuswalk_bench/peers only")

    def test_include_folders_of_the_distribution_are_ignored(self):
        self.finds({"engine/simulation/x.cpp": "#include <bullet/btBulletDynamicsCommon.h>\n#include <eigen3/Eigen/Core>\n"},
                   "engine/simulation/x.cpp:1:10: error third-party: <btBulletDynamicsCommon.h> may be included in tests only")

    def test_third_party_headers_have_one_place(self):
        for header, place in (("stb/stb_image.h", "scene/import"),
                              ("yaml-cpp/yaml.h", "config/loader/yaml"), ("spdlog/spdlog.h", "tools/campuswalk/base"),
                              ("CLI/CLI.hpp", "tools/campuswalk/command_line")):
            with self.subTest(header):
                line = "#include <%s>\n" % header
                self.finds({"engine/simulation/contact_detector.cpp": line, place + "/x.cpp": line},
                           "engine/simulation/contact_detector.cpp:1:10: error third-party: <%s> may be included in %s only"
                           % (header, place))

    def test_a_benchmarks_peers_may_include_our_libraries(self):
        line = "#include <assimp/scene.h>\n"
        self.finds({"engine/simulation/contact_detector.cpp": line, "scene/import/x.cpp": line, "tools/campuswalk_bench/peers/x.cpp": line},
                   "engine/simulation/contact_detector.cpp:1:10: error third-party: <assimp/scene.h> may be included in "
                   "scene/import, tools/campuswalk_bench/peers only")

    def test_drawing_has_one_place(self):
        for header in ("GL/osmesa.h", "pango/pangocairo.h", "spng.h", "fontconfig/fontconfig.h"):
            with self.subTest(header):
                line = "#include <%s>\n" % header
                self.finds({"scene/model/model.cpp": line, "engine/render/x.cpp": line},
                           "scene/model/model.cpp:1:10: error third-party: <%s> may be included in engine/render, "
                           "tests/engine/render only" % header)

    def test_peers_stay_out_of_the_program(self):
        for header in ("fcl/fcl.h", "ode/ode.h", "embree3/rtcore.h", "tbb/global_control.h"):
            with self.subTest(header):
                line = "#include <%s>\n" % header
                [diagnostic] = self.diagnostics({"tools/campuswalk_bench/benchmarks.cpp": line,
                                               "tools/campuswalk_bench/peers/x.cpp": line})
                self.assertTrue(diagnostic.startswith("tools/campuswalk_bench/benchmarks.cpp:1:10: error "
                                                     "third-party: "), diagnostic)

    def test_peers_see_one_header_of_the_benchmark(self):
        [diagnostic] = self.diagnostics({
            "tools/campuswalk_bench/engine/engine.h": HEADER, "tools/campuswalk_bench/measure/measurement.h": HEADER,
            "tools/campuswalk_bench/peers/x.cpp":
                '#include "tools/campuswalk_bench/engine/engine.h"\n#include "tools/campuswalk_bench/measure/measurement.h"\n'})
        self.assertTrue(diagnostic.startswith("tools/campuswalk_bench/peers/x.cpp:2:10: error layer: "), diagnostic)

    def test_undeclared_headers_are_found(self):
        self.finds({"engine/simulation/x.cpp": "#include <boost/asio.hpp>\n"},
                   "engine/simulation/x.cpp:1:10: error third-party: <boost/asio.hpp> has no place in "
                   "tools/check_layers/table.py")

    def test_includes_start_at_the_root(self):
        self.finds({"engine/simulation/x.cpp": '#include "avatar.h"\n#include <engine/script/avatar.h>\n', "engine/script/avatar.h": HEADER},
                   'engine/simulation/x.cpp:1:10: error include-path: "avatar.h" isn\'t a file below the repository\'s root',
                   'engine/simulation/x.cpp:2:10: error include-path: files of the project are included as "engine/script/avatar.h"')

    def test_include_cycles_are_found(self):
        self.finds({"scene/model/a.h": HEADER + '#include "scene/model/b.h"\n', "scene/model/b.h": HEADER + '#include "scene/model/c.h"\n',
                    "scene/model/c.h": HEADER + '#include "scene/model/a.h"\n'},
                   "scene/model/c.h:2:10: error include-cycle: scene/model/a.h -> scene/model/b.h -> scene/model/c.h -> scene/model/a.h")

    def test_headers_without_pragma_once_are_found(self):
        self.finds({"scene/model/a.h": "// #pragma once\n", "scene/model/b.h": "// why\n" + HEADER},
                   "scene/model/a.h:1:1: error pragma-once: a header needs #pragma once")

    def test_libm_in_the_core_is_found(self):
        ends = " differs between machines; see collision/geometry/trigonometry.h for what doesn't"
        for code, column, name in (("a = std::sin(b);", 10, "sin"), ("a = 1 + pow(b, 2);", 9, "pow"),
                                   ("return ::atan2(y, x);", 10, "atan2"), ("a = std::fma (b, c, d);", 10, "fma"),
                                   ("a = __builtin_cosf(b);", 5, "__builtin_cosf"), ("v = v.array().exp();", 15, "exp"),
                                   ("v = v.array().pow(3);", 15, "pow"),
                                   ("Eigen::AngleAxisd a(b, c);", 8, "AngleAxisd")):
            with self.subTest(code):
                self.finds({"engine/simulation/x.cpp": code, "engine/render/x.cpp": code, "tests/x.cpp": code},
                           "engine/simulation/x.cpp:1:%d: error same-bits: %s%s" % (column, name, ends))

    def test_exact_functions_are_allowed(self):
        self.finds({"collision/geometry/x.cpp": "a = std::sqrt(b) + std::abs(c) + std::floor(d) + std::nextafter(e, f);\n"
                                       "b = angle.sin + trace.log(c) + sin_cos(d).cos + text_log(e);\n"
                                       "if (std::isfinite(a)) {}  // no std::sin(x) here\n"
                                       'const char* s = "std::cos(x)"; /* pow(\n a, b) */ auto t = R"(exp(x))";\n'})

    def test_clocks_in_the_core_are_found(self):
        self.finds({"engine/simulation/x.cpp": "#include <chrono>\n", "engine/render/x.cpp": "#include <chrono>\n"},
                   "engine/simulation/x.cpp:1:10: error same-bits: <chrono> is not for engine/simulation: a walk knows no clock but its ticks")

    def test_compiler_flags_that_change_results_are_found(self):
        self.finds({"CMakeLists.txt": "# never -march=native\nadd_compile_options(-O2 -march=native)\n",
                    "CMakePresets.json": '{"CMAKE_CXX_FLAGS": "-ffast-math"}\n',
                    "collision/bvh8/kernels/CMakeLists.txt": "target_compile_options(k PRIVATE -mavx2 -Ofast)\n",
                    "tools/cmake/X.cmake": "add_compile_options(-ffp-contract=off)\n"},
                   "CMakeLists.txt:2:25: error compiler-flag: -march=native changes results; it is for kernel folders",
                   "CMakePresets.json:1:22: error compiler-flag: -ffast-math changes results",
                   "collision/bvh8/kernels/CMakeLists.txt:1:41: error compiler-flag: -Ofast changes results")

    def test_includes_in_comments_are_ignored(self):
        self.finds({"collision/geometry/x.cpp": '// #include "engine/a.h"\n/*\n#include <GL/gl.h>\n*/\nint a = 1\'000;\n'})


if __name__ == "__main__":
    unittest.main()
