#!/usr/bin/env python3
"""`campuswalk imgdiff`. `imgdiff_test.py PROGRAM [--without-rendering]`."""

import json
import struct
import sys
import unittest

from program import ProgramCase, main, png

WITHOUT_RENDERING = "--without-rendering" in sys.argv


def picture(width, height, color_at):
    """A PNG file with the colours that `color_at(x, y)` returns."""
    return png(width, height, (b"\0" + bytes(c for x in range(width) for c in color_at(x, y)) for y in range(height)))


def grey(x, y):
    return 100, 100, 100


def spotted(x, y):
    """Ten white pixels in a row."""
    return (255, 255, 255) if y == 20 and 30 <= x < 40 else grey(x, y)


def striped(x, y):
    """Stripes below the threshold of the pixel rule."""
    return (115, 115, 115) if x % 2 else grey(x, y)


@unittest.skipIf(WITHOUT_RENDERING, "this build reads no pictures")
class Imgdiff(ProgramCase):
    def setUp(self):
        super().setUp()
        for name, color_at in (("grey", grey), ("spotted", spotted), ("striped", striped)):
            self.write(name + ".png", picture(128, 64, color_at))
        self.write("small.png", picture(20, 10, grey))

    def imgdiff(self, *arguments):
        outcome = self.run_program("imgdiff", *arguments)
        self.assertEqual(outcome.err, "")
        return outcome

    def refused(self, *arguments, expected):
        before = self.contents()
        outcome = self.run_program("imgdiff", *arguments)
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, expected)
        self.assertEqual(self.contents(), before)

    def test_equal_images_exit_with_0(self):
        outcome = self.imgdiff("grey.png", "grey.png")
        self.assertEqual(outcome.code, 0)
        self.assertRegex(outcome.out, "^grey.png and grey.png .*: 0 pixels .* 1[.]0000\n$")

    def test_changed_pixels_are_counted(self):
        outcome = self.imgdiff("grey.png", "spotted.png", "--min-tile-ssim", "-1")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.out, "^grey.png and spotted.png .*: 10 pixels .*0[.]122 %.* 0\n$")
        for limit, code in (("10", 0), ("9", 1)):
            self.assertEqual(self.imgdiff("grey.png", "spotted.png", "--min-tile-ssim", "-1", "--max-diff-pixels",
                                          limit).code, code)
        for limit, code in (("0.0013", 0), ("0.0012", 1)):
            self.assertEqual(self.imgdiff("grey.png", "spotted.png", "--min-tile-ssim", "-1", "--max-diff-pixel-ratio",
                                          limit).code, code)
        self.assertEqual(self.imgdiff("grey.png", "spotted.png", "--min-tile-ssim", "-1", "--threshold", "0.6").code, 0)

    def test_faint_stripes_are_found_by_similarity(self):
        outcome = self.imgdiff("grey.png", "striped.png")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.out, "64x64 pixels at 0,0 .*0[.][0-9]{3}.* 0[.]970")
        self.assertEqual(self.imgdiff("grey.png", "striped.png", "--min-tile-ssim", "0.1").code, 0)

    def test_masked_pixels_are_ignored(self):
        self.assertEqual(self.imgdiff("grey.png", "spotted.png", "--mask", "30,20,10,1").code, 0)
        self.assertEqual(self.imgdiff("grey.png", "spotted.png", "--mask", "30,20,9,1").code, 1)
        self.assertEqual(self.imgdiff("grey.png", "spotted.png", "--mask", "30,20,5,1", "--mask", "35,20,5,1").code, 0)
        for mask in ("1,2,3", "1,2,3,4,5", "a,b,c,d", "1,2,3,-4", "1.5,2,3,4", ",,,", "1,2,3,99999999999"):
            self.refused("grey.png", "spotted.png", "--mask=" + mask, expected="X,Y,WIDTH,HEIGHT")

    def test_json(self):
        outcome = self.imgdiff("grey.png", "spotted.png", "--json")
        found = json.loads(outcome.out)
        self.assertEqual(outcome.code, 1)
        self.assertEqual((found["same"], found["diff_pixels"], found["diff_pixel_ratio"]), (False, 10, 10 / 128 / 64))
        self.assertEqual((found["width"], found["height"], found["worst_tile"]), (128, 64, [0, 0, 64, 64]))
        self.assertLess(found["tile_ssim"], 1)
        self.assertEqual(json.loads(self.imgdiff("grey.png", "grey.png", "--json").out)["same"], True)

    def test_image_of_the_difference(self):
        self.imgdiff("grey.png", "spotted.png", "--diff", "new/diff.png")
        drawn = self.read("new/diff.png")
        self.assertEqual(struct.unpack(">II", drawn[16:24]), (128, 64))
        self.assertEqual(self.imgdiff("new/diff.png", "grey.png").code, 1)
        self.refused("grey.png", "spotted.png", "--diff", "small.campus.yaml/a.png",
                     expected="^small.campus.yaml/a.png: error output-unwritable: ")

    def test_images_of_different_size_differ(self):
        outcome = self.imgdiff("grey.png", "small.png", "--diff", "diff.png")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.out, "^grey.png and small.png .*128x64.*20x10\n$")
        self.assertNotIn("diff.png", self.contents())
        self.assertEqual(json.loads(self.imgdiff("grey.png", "small.png", "--json").out)["same"], False)

    def test_files_that_are_not_images_are_refused(self):
        self.refused("none.png", "grey.png", expected="^none.png: error missing-file: ")
        self.refused("grey.png", "room.obj", expected="^room.obj: error bad-picture: ")
        self.refused("avatars", "grey.png", expected="^avatars: error unreadable-file: ")
        self.write("cut.png", self.read("grey.png")[:-30])
        self.refused("grey.png", "cut.png", expected="^cut.png: error bad-picture: ")

    def test_numbers_out_of_range_are_refused(self):
        self.refused("grey.png", "grey.png", "--threshold", "1.5", expected="--threshold")
        self.refused("grey.png", "grey.png", "--min-tile-ssim", "2", expected="--min-tile-ssim")
        self.refused("grey.png", "grey.png", "--max-diff-pixels", "-1", expected="--max-diff-pixels")
        self.refused("grey.png", "grey.png", "--max-diff-pixel-ratio", "2", expected="--max-diff-pixel-ratio")


@unittest.skipUnless(WITHOUT_RENDERING, "this build reads pictures")
class WithoutRendering(ProgramCase):
    def test_the_build_option_is_named(self):
        self.assert_refused(self.run_program("imgdiff", "a.png", "b.png"), "error: CAMPUSWALK_RENDER=ON", code=3)


if __name__ == "__main__":
    if WITHOUT_RENDERING:
        sys.argv.remove("--without-rendering")
    main()
