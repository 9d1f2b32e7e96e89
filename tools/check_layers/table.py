"""What is allowed where. A place is a folder or a file, from the repository's root.

A folder that isn't named here belongs to the nearest one above it that is.
"""

ANYWHERE = "anywhere"

# Who may include whom: place -> places of the project, each with its subfolders. Every place may include itself.
PROJECT = {
    "collision/base": [],
    "collision/geometry": ["collision/base"],
    "collision/hybrid": ["collision/base", "collision/geometry"],
    "collision/bvh8": ["collision/base", "collision/geometry"],
    "collision/mesh": ["collision/base", "collision/geometry", "collision/hybrid", "collision/bvh8"],
    "collision/world": ["collision/base", "collision/geometry", "collision/mesh"],
    "collision/mover": ["collision/base", "collision/geometry", "collision/mesh", "collision/world"],
    "scene/base": ["collision/base"],
    "scene/model": ["scene/base", "collision"],
    "scene/lint": ["scene/model", "scene/base", "collision"],
    "scene/procedural": ["scene/model", "scene/base", "collision"],
    "scene/import/source": ["scene/model", "scene/base", "collision"],
    "scene/import/assimp": ["scene/import/source", "scene/model", "scene/base", "collision"],
    "scene/import/gltf": ["scene/import/source", "scene/model", "scene/base", "collision"],
    "scene/import": ["scene/model", "scene/base", "collision"],
    "scene/cache": ["scene/import", "scene/model", "scene/base", "collision"],
    "scene/campus": ["scene/cache", "scene/import", "scene/model", "scene/base", "collision"],
    "scene/suggest": ["scene/campus", "scene/lint", "scene/model", "scene/base", "collision"],
    # The simulation core: it hands out records and knows none of those that read them.
    "engine/events": ["scene", "collision"],
    "engine/script": ["engine/events", "scene", "collision"],
    "engine/record": ["engine/script", "engine/events", "scene", "collision"],
    "engine/expect": ["engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/simulation": ["engine/expect", "engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/observers": ["engine/expect", "engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/testing": ["engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/report": ["engine/simulation", "engine/expect", "engine/record", "engine/script", "engine/events", "scene",
                      "collision"],
    # Images are plain data: nothing that draws is needed to compare them.
    "engine/render/image": ["engine/events", "scene", "collision"],
    "engine/render/compare": ["engine/render/image", "engine/script", "engine/events"],
    "engine/render/geometry": ["engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/render/gl": ["engine/render/geometry", "engine/render/image", "scene", "collision"],
    "engine/render/passes": ["engine/render/gl", "engine/render/geometry", "engine/render/image", "engine/script",
                             "scene", "collision"],
    "engine/render/overlay": ["engine/render/gl", "engine/render/geometry", "engine/render/image", "engine/record",
                              "engine/script", "engine/events", "scene", "collision"],
    "engine/render": ["engine/record", "engine/script", "engine/events", "scene", "collision"],
    "config/loader": ["engine/simulation", "engine/expect", "engine/record", "engine/script", "engine/events", "scene",
                      "collision"],
    "tools": [],
    "tools/campuswalk": ["config/loader", "engine", "scene", "collision"],
    "tools/campuswalk/bench": ["tools/campuswalk", "engine", "scene", "collision"],
    # Other people's engines: of ours they see what they are given and what they are asked.
    "tools/campuswalk/bench/peers": ["tools/campuswalk/bench/engine.h", "collision"],
    "tests": [ANYWHERE],
}

# Single files (named without .h or .cpp) that may include less than their folder. The oracle must share no
# function with what it judges: of collision/ it sees the world's data, no more.
_ORACLE = ["tests/support/penetration_oracle", "tests/support/plain_geometry", "tests/support/plain_solids",
           "tests/support/triangle_grid"]
STRICTER = {file: _ORACLE + ["collision/mesh/mesh_collider", "collision/geometry/shapes", "collision/geometry/triangle_mesh",
                             "collision/world/world"] for file in _ORACLE}

# Where headers of others may be included; the longest prefix that matches decides. The distribution puts
# some in a folder that can be spelled too: see SPELLED_AWAY.
THIRD_PARTY = {
    "Eigen/": [ANYWHERE],
    "hwy/": ["collision/bvh8/kernels"],
    "BulletCollision/BroadphaseCollision/": ["collision/world/bullet_broad_phase.cpp", "tools/campuswalk/bench/peers"],
    "LinearMath/": ["collision/world/bullet_broad_phase.cpp"],
    # Bullet's narrow phase, bodies and dynamics: what the hybrid trees are there for.
    "BulletCollision/": ["tests", "tools/campuswalk/bench/peers"],
    "BulletDynamics/": ["tests", "tools/campuswalk/bench/peers"],
    "BulletSoftBody/": ["tests"],
    "btBulletCollisionCommon.h": ["tests"],
    "btBulletDynamicsCommon.h": ["tests"],
    "assimp/": ["scene/import", "tools/campuswalk/bench/peers"],
    "stb/": ["scene/import"],
    "xxhash.h": ["scene/base/content_hash.cpp"],
    "draco/": ["scene/import/gltf", "tests/scene/import/gltf"],
    "meshoptimizer.h": ["scene/import/gltf", "tests/scene/import/gltf"],
    "webp/": ["scene/import", "tests/scene/import/gltf"],
    "nlohmann/": ["scene/import/gltf", "engine/observers", "engine/render/snapshot/channel_files.cpp", "engine/report", "tools/campuswalk", "tests"],
    "pugixml": ["engine/report", "scene/import/source/collada_text.cpp"],
    "GL/": ["engine/render", "tests/engine/render"],
    "EGL/": ["engine/render"],
    "KHR/": ["engine/render"],
    "malloc.h": ["tools/campuswalk/bench"],
    "dlfcn.h": ["engine/render", "tools/campuswalk/bench"],
    "cairo": ["engine/render", "tests/engine/render", "tools/campuswalk/bench"],
    "fontconfig/": ["engine/render", "tests/engine/render"],
    "pango/": ["engine/render", "tests/engine/render"],
    "libdeflate.h": ["engine/render"],
    "gif_lib.h": ["engine/render", "tests/engine/render"],
    "spng.h": ["engine/render", "tests/engine/render"],
    "yaml-cpp/": ["config/loader"],
    "CLI/": ["tools/campuswalk/command_line"],
    "fmt/": ["tools/campuswalk"],
    "spdlog/": ["tools/campuswalk"],
    "re2/": ["tools/campuswalk/run"],
    "poll.h": ["scene/import/helper", "tools/campuswalk/run"],
    "spawn.h": ["scene/import/helper", "tools/campuswalk"],
    "unistd.h": ["scene/cache", "scene/import", "scene/base/whole_file.cpp", "tools/campuswalk", "tests"],
    "fcntl.h": ["scene/cache", "scene/import", "tools/campuswalk", "tests"],
    "sys/mman.h": ["collision/base/large_pages.cpp", "scene/cache", "scene/import/helper", "tools/campuswalk/cache_choice.cpp"],
    "sys/": ["scene/cache", "scene/import", "tools/campuswalk", "tests"],
    "gtest/": ["tests"],
    "gmock/": ["tests", "engine/testing"],
    "doctest/": ["tests"],
    "CGAL/": ["tests", "tools/campuswalk/bench/peers"],
    "fcl/": ["tools/campuswalk/bench/peers"],
    "embree3/": ["tools/campuswalk/bench/peers"],
    "tbb/": ["tools/campuswalk/bench/peers"],
    "ode/": ["tools/campuswalk/bench/peers"],
}
SPELLED_AWAY = ("bullet/", "eigen3/")

# Places whose results go into a walk's hash: no libm but sqrt and what is exact, no clock, no chance.
SAME_EVERYWHERE = ["collision", "scene", "engine", "config/loader"]
MAY_DIFFER = ["scene/import", "engine/render"]
REFUSED_STANDARD = {
    "chrono": "a walk knows no clock but its ticks",
    "ctime": "a walk knows no clock but its ticks",
    "random": "the standard's distributions differ between libraries",
    "complex": "it calls libm",
    "valarray": "it calls libm",
    "cfenv": "the rounding mode is the same everywhere",
    "thread": "a walk is one thread",
}

# Instruction sets are chosen in kernel folders alone.
KERNEL_FOLDERS = ["collision/bvh8/kernels"]

CODE_FOLDERS = ("collision", "scene", "engine", "config", "tools", "tests")


def place_of(path, places):
    """The longest of `places` that is `path` or a folder above it; None without one."""
    while path:
        if path in places:
            return path
        path = path.rpartition("/")[0]
    return None


def is_in(path, places):
    """Whether one of `places` is `path`, lies above it, or is ANYWHERE."""
    return ANYWHERE in places or place_of(path, places) is not None


def needs_same_bits(path):
    """Whether what the file computes must be the same on every machine."""
    nearest = place_of(path, SAME_EVERYWHERE + MAY_DIFFER)
    return nearest in SAME_EVERYWHERE
