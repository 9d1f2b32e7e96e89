#!/usr/bin/env python3
"""What a checkout names is read in the checkout only, or in what --root adds; nothing else is opened or quoted."""

import os

from program import CAMPUS, ROOM, WALK, CheckoutCase, main, plain_png

SECRET = "password: hunter2"


class ConfinedReads(CheckoutCase):
    def setUp(self):
        super().setUp()
        self.write("../elsewhere/secret.txt", SECRET + "\n")
        for name, text in (("room.obj", ROOM), ("small.campus.yaml", CAMPUS), ("short.walk.yaml", WALK),
                           ("part.steps.yaml", "steps: [{wait: 1}]\n"), ("a.avatar.yaml", "height: 1.7\n"),
                           ("night.light.yaml", "sun_intensity: 0\n"),
                           ("avatars/adult.avatar.yaml", "height: 1.8\n")):
            for folder in ("../elsewhere/", ".hidden/", ".git/"):
                self.write(folder + name, text)

    def reads(self, *arguments):
        return self.run_program("run", "--rendering-backend", "none", *arguments)

    def assert_outside(self, place, *arguments):
        """Refused there, passes with the root; returns what was said."""
        outcome = self.reads(*arguments)
        self.assertEqual(outcome.code, 2, outcome.out + outcome.err)
        self.assertIn(place, outcome.err)
        self.assertIn("outside-project", outcome.err)
        self.assertNotIn("hunter2", outcome.out + outcome.err)
        passed = self.reads(*arguments, "--root", self.path("../elsewhere"))
        self.assertEqual(passed.code, 0, passed.err)

    def assert_hidden(self, *arguments):
        outcome = self.reads(*arguments, "--root", self.path("../elsewhere"))
        self.assertEqual(outcome.code, 2, outcome.out + outcome.err)
        self.assertIn("starts with '.'", outcome.err)

    def test_campuses(self):
        for place in ("../elsewhere/small.campus.yaml", self.path("../elsewhere/small.campus.yaml"),
                      "linked/small.campus.yaml", "linked.campus.yaml"):
            self.link("linked", "../elsewhere")
            self.link("linked.campus.yaml", "../elsewhere/small.campus.yaml")
            self.write("short.walk.yaml", WALK.replace("small.campus.yaml", place))
            self.assert_outside("short.walk.yaml:1:9: error outside-project: ", "short.walk.yaml")
        for place in (".git/small.campus.yaml", ".hidden/small.campus.yaml"):
            self.write("short.walk.yaml", WALK.replace("small.campus.yaml", place))
            self.assert_hidden("short.walk.yaml")

    def link(self, name, target):
        if not os.path.lexists(self.path(name)):
            os.symlink(target, self.path(name))

    def test_models(self):
        self.link("linked.obj", "../elsewhere/room.obj")
        for place in ("../elsewhere/room.obj", self.path("../elsewhere/room.obj"), "linked.obj"):
            self.write("small.campus.yaml", CAMPUS.replace("room.obj", place))
            self.assert_outside("small.campus.yaml:2:11: error outside-project: ", "short.walk.yaml")
        self.write("small.campus.yaml", CAMPUS.replace("room.obj", ".git/room.obj"))
        self.assert_hidden("short.walk.yaml")

    def test_a_tree_of_links_works_with_the_root_that_they_lead_to(self):
        """As Bazel's runfiles are."""
        self.write("../elsewhere/room.obj", "mtllib room.mtl\n" + ROOM.replace("f 1 4 3", "usemtl red\nf 1 4 3"))
        self.write("../elsewhere/room.mtl", "newmtl red\nmap_Kd textures/red.png\n")
        self.write("../elsewhere/textures/red.png", plain_png(2, 2, (255, 0, 0)))
        os.makedirs(self.path("../runfiles/textures"))
        for name in ("room.obj", "room.mtl", "textures/red.png", "short.walk.yaml", "small.campus.yaml"):
            os.symlink(self.path("../elsewhere/" + name), self.path("../runfiles/" + name))
        os.makedirs(self.path("../runfiles/avatars"))
        os.symlink(self.path("../elsewhere/a.avatar.yaml"), self.path("../runfiles/avatars/adult.avatar.yaml"))
        outcome = self.run_program("run", "short.walk.yaml", "--rendering-backend", "none", "--root",
                                   self.path("../elsewhere"), cwd=self.path("../runfiles"))
        self.assertEqual((outcome.code, outcome.err.count("warning")), (0, 0), outcome.err)

    def test_whether_a_file_exists_there_is_not_told(self):
        said = set()
        for name in ("room.obj", "nothing.obj"):
            self.write("small.campus.yaml", CAMPUS.replace("room.obj", "../elsewhere/" + name))
            said.add(self.reads("short.walk.yaml").err.replace(name, "NAME"))
        self.assertEqual(len(said), 1, said)

    def test_included_steps(self):
        for place in ("../elsewhere/part.steps.yaml", "linked.steps.yaml"):
            self.link("linked.steps.yaml", "../elsewhere/part.steps.yaml")
            self.write("short.walk.yaml", WALK.replace("  - turn: 180\n", "  - turn: 180\n  - include: %s\n" % place))
            self.assert_outside("short.walk.yaml:7:14: error outside-project: ", "short.walk.yaml")
        self.write("part.steps.yaml", "steps: [{include: .git/part.steps.yaml}]\n")
        self.write("short.walk.yaml", WALK.replace("  - turn: 180\n", "  - turn: 180\n  - include: part.steps.yaml\n"))
        self.assert_hidden("short.walk.yaml")

    def test_profiles(self):
        self.link("avatars/far.avatar.yaml", "../../elsewhere/a.avatar.yaml")
        self.write("short.walk.yaml", WALK.replace("adult", "far"))
        self.assert_outside("short.walk.yaml:2:9: error outside-project: ", "short.walk.yaml")
        os.makedirs(self.path("lights"))
        self.link("lights/far.light.yaml", "../../elsewhere/night.light.yaml")
        self.write("short.walk.yaml", WALK + "light: far\n")
        self.assertIn("outside-project", self.reads("short.walk.yaml").err)

    def test_walks(self):
        self.link("linked.walk.yaml", "../elsewhere/short.walk.yaml")
        self.assert_outside("linked.walk.yaml: error outside-project: ", "linked.walk.yaml")
        os.remove(self.path("linked.walk.yaml"))
        self.link("linked", "../elsewhere")
        self.assert_outside("linked/short.walk.yaml: error outside-project: ", ".")
        for mark in ("walks.config.yaml", ".git/HEAD"):
            self.write("../elsewhere/" + mark, "workers: 1\n")  # a link can't lead to a project of its own choice
            self.assertIn("linked/short.walk.yaml: error outside-project: ", self.reads(".").err)
            self.assertEqual(self.run_program("run", "short.walk.yaml", cwd=self.path("linked")).code, 0)
        os.remove(self.path("../elsewhere/walks.config.yaml"))
        os.remove(self.path("linked"))
        for text in ("walks: ../elsewhere\n", "walks: %s\n" % self.path("../elsewhere")):
            self.write("walks.config.yaml", text)
            self.assert_outside("walks.config.yaml:1:8: error outside-project: ")

    def test_a_secret_is_not_quoted_as_yaml(self):
        for name in ("a.walk.yaml", "walks.config.yaml"):
            self.link(name, "../elsewhere/secret.txt")
            outcome = self.reads()
            self.assertEqual(outcome.code, 2)
            self.assertNotIn("password", outcome.out + outcome.err)
            os.remove(self.path(name))

    def test_the_project_ends_at_its_configuration(self):
        self.write("deeper/walks.config.yaml", "workers: 1\n")
        self.write("deeper/short.walk.yaml", WALK.replace("small.campus.yaml", "../small.campus.yaml"))
        outcome = self.reads("deeper/short.walk.yaml")
        self.assertIn("deeper/short.walk.yaml:1:9: error outside-project: ", outcome.err)
        self.assertEqual(self.reads("deeper/short.walk.yaml", "--root", ".").code, 0)

    def test_without_a_repository_the_project_is_the_current_folder(self):
        os.rename(self.path(".git"), self.path("git"))
        self.write("walks/short.walk.yaml", WALK.replace("small.campus.yaml", "../small.campus.yaml"))
        self.assertEqual(self.reads("walks/short.walk.yaml").code, 0)
        here = self.run_program("run", "short.walk.yaml", cwd=self.path("walks"))
        self.assertIn("short.walk.yaml:1:9: error outside-project: ", here.err)

    def test_a_root_must_exist_and_several_may_be_named(self):
        self.write("short.walk.yaml", WALK.replace("small.campus.yaml", "../elsewhere/small.campus.yaml"))
        self.write("../third/room.obj", ROOM)
        self.write("../elsewhere/small.campus.yaml", CAMPUS.replace("room.obj", "../third/room.obj"))
        roots = ("--root", "../elsewhere", "--root", "../third")
        self.assertEqual(self.reads("short.walk.yaml", *roots).code, 0)
        self.passes("validate", "short.walk.yaml", *roots)
        self.assertIn("small.campus.yaml:2:11: error outside-project",
                      self.reads("short.walk.yaml", *roots[:2]).err)
        self.assert_bad_usage(self.reads("short.walk.yaml", "--root", "nowhere"), "run", "--root 'nowhere'")

    def test_every_command_has_roots(self):
        self.write("short.walk.yaml", WALK.replace("small.campus.yaml", "../elsewhere/small.campus.yaml"))
        self.write("near.campus.yaml", CAMPUS.replace("room.obj", "../elsewhere/room.obj"))
        root = ("--root", "../elsewhere")
        self.passes("run", "short.walk.yaml", *root, "--jsonl", "a.jsonl", "--reporter", "jsonl=r.jsonl")
        for arguments in (("validate", "near.campus.yaml"), ("replay", "r.jsonl", "--verify"),
                          ("replay", "a.jsonl", "--walk", "short.walk.yaml"),
                          ("diff", "a.jsonl", "a.jsonl", "--walk", "short.walk.yaml", "--pictures", "pictures"),
                          ("snapshot", "near.campus.yaml", "--camera", "top", "-o", "plan.png")):
            outcome = self.run_program(*arguments)
            if arguments[0] != "diff":  # equal logs need no walk
                self.assertEqual(outcome.code, 2, arguments)
                self.assertIn("outside-project", outcome.err)
            outcome = self.run_program(*arguments, *root)
            self.assertEqual(outcome.code, 0, (arguments, outcome.err))

    def test_reports_name_walks_of_the_project_only(self):
        self.passes("run", "short.walk.yaml", "--reporter", "jsonl=r.jsonl")
        for place in ("../elsewhere/short.walk.yaml", self.path("../elsewhere/short.walk.yaml"), ".git/short.walk.yaml"):
            self.write("forged.jsonl", self.read("r.jsonl").decode().replace('"short.walk.yaml"', '"%s"' % place))
            outcome = self.run_program("replay", "forged.jsonl")
            self.assertEqual(outcome.code, 2)
            self.assertIn("outside-project", outcome.err)

    def test_golden_logs_are_regular_and_of_bounded_size(self):
        self.write("short.walk.yaml", WALK + "  - log: {golden: true}\n")
        golden = "short.walk.yaml-snapshots/log.jsonl"
        self.assertEqual(self.reads("short.walk.yaml", "-u").code, 0)
        os.rename(self.path(golden), self.path("../elsewhere/log.jsonl"))
        self.link(golden, "../../elsewhere/log.jsonl")
        self.assert_outside(golden + ": error outside-project: ", "short.walk.yaml")
        os.remove(self.path(golden))
        self.link(golden, "../../elsewhere/secret.txt")
        self.assertNotIn("hunter2", self.reads("short.walk.yaml", "--root", "../elsewhere").err)
        os.remove(self.path(golden))
        os.mkfifo(self.path(golden))
        outcome = self.reads("short.walk.yaml")
        self.assertEqual((outcome.code, outcome.err.count("isn't a regular file")), (2, 1), outcome.err)
        os.remove(self.path(golden))
        self.write(golden, "")
        os.truncate(self.path(golden), 300_000_000)
        self.assertIn(golden + ": error too-large: ", self.reads("short.walk.yaml").err)

    def test_a_link_to_a_model_does_not_move_the_project(self):
        """Its textures are looked up from where it is named."""
        self.write("deep/er/room.obj", "mtllib room.mtl\n" + ROOM.replace("f 1 4 3", "usemtl red\nf 1 4 3"))
        self.write("room.mtl", "newmtl red\nmap_Kd ../textures/red.png\n")
        self.write("../textures/red.png", plain_png(2, 2, (255, 0, 0)))
        os.remove(self.path("room.obj"))
        self.link("room.obj", "deep/er/room.obj")
        self.assertIn("bad-texture", self.reads("short.walk.yaml").err)

    def test_a_link_cannot_choose_a_project_beyond_a_folder_of_another_owner(self):
        if os.geteuid() != 0:
            self.skipTest("only root can give folders away")
        self.write("../users/other/.git/HEAD", "")
        self.write("../users/other/secret.walk.yaml", SECRET + "\n")
        os.chown(self.path("../users"), 12345, 12345)
        os.chown(self.path("../"), 12345, 12345)
        self.link("linked", "../users")
        outcome = self.reads(".")
        self.assertIn("linked/other/secret.walk.yaml: error outside-project: ", outcome.err)
        self.assertNotIn("password", outcome.out + outcome.err)

    def test_textures_beside_the_projects_folder_are_not_read(self):
        """The usual layout has textures beside the model's folder, which here is outside."""
        self.write("room.mtl", "newmtl red\nmap_Kd ../textures/red.png\n")
        self.write("room.obj", "mtllib room.mtl\n" + ROOM.replace("f 1 4 3", "usemtl red\nf 1 4 3"))
        self.write("../textures/red.png", plain_png(2, 2, (255, 0, 0)))
        self.assertIn("bad-texture", self.reads("short.walk.yaml").err)
        self.assertNotIn("bad-texture", self.reads("short.walk.yaml", "--root", "..").err)
        self.assertNotIn("bad-texture", self.run_program("info", "room.obj").err, "named on the command line")


if __name__ == "__main__":
    main()
