"""A cache with a good model's entries under the names of those of a bad one: what a checkout must not smuggle in."""

import os
import re
import shutil

NARROW = re.compile(r"(?m)^v (-?)1 ([03]) -6")


def narrow_the_door(model):
    """Makes the doorway of a school that `init` wrote narrower than a visitor."""
    with open(model, encoding="utf-8") as file:
        text = NARROW.sub(r"v \g<1>0.25 \2 -6", file.read())
    with open(model, "w", encoding="utf-8") as file:
        file.write(text)


class PoisonedCache:
    """Narrows the door of the project in `folder`, below that of the test, and adds the cache to it as .campuswalk/ and campuswalk/cache/."""

    def __init__(self, test, folder):
        self.test, self.project = test, test.path(folder)
        good = self.entries("good")
        narrow_the_door(os.path.join(self.project, "school.obj"))
        bad = self.entries("bad")
        assert set(bad) == set(good), (good, bad)
        self.folders = [os.path.join(self.project, name) for name in (".campuswalk", "campuswalk/cache", ".cache/campuswalk")]
        for each in self.folders:
            os.makedirs(each)
            for kind, name in good.items():
                shutil.copy(test.path("good/" + name), os.path.join(each, bad[kind]))

    def entries(self, cache):
        """kind -> file, after a run."""
        self.test.run_program("run", "walks/visit.walk.yaml", "--rendering-backend", "none", cwd=self.project,
                              env=dict(os.environ, CAMPUSWALK_CACHE_DIR=self.test.path(cache)))
        return {name.split(".", 1)[1]: name for name in os.listdir(self.test.path(cache)) if ".stamp." not in name}

    def elsewhere(self):
        """A copy outside of the project."""
        return shutil.copytree(self.folders[0], self.test.path("elsewhere"))
