"""What is allowed where. A place is a folder, from the repository's root.

A folder that isn't named here belongs to the nearest one above it that is.
"""

ANYWHERE = "anywhere"

# The layers below the tools.
_CORE = ["config/loader", "engine", "scene", "collision"]


def _rooms(folder, names, below):
    """Folders in `folder`, each of which may include those before it, and what is below."""
    return {"%s/%s" % (folder, name): ["%s/%s" % (folder, earlier) for earlier in names[:i]] + below for i, name in enumerate(names)}


# Who may include whom: place -> places of the project, including their subfolders. Every place may include itself.
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
    "scene/import/source": ["scene/model", "scene/base", "collision"],
    "scene/import/assimp": ["scene/import/source", "scene/model", "scene/base", "collision"],
    "scene/import/gltf": ["scene/import/source", "scene/model", "scene/base", "collision"],
    # Writes models; what reads them is its test.
    "scene/export": ["scene/model", "scene/base", "collision"],
    "scene/process": ["scene/base"],
    "scene/import": ["scene/model", "scene/process", "scene/base", "collision"],
    # Makes campuses from maps; import knows nothing of it.
    **_rooms("scene/osm", ["read", "geometry", "buildings", "ways", "bridges", "meaning", "objects"],
             ["scene/export", "scene/import", "scene/model", "scene/base", "collision"]),
    "scene/osm": ["scene/export", "scene/import", "scene/model", "scene/base", "collision"],
    "scene/cache": ["scene/import", "scene/model", "scene/base", "collision"],
    "scene/campus": ["scene/cache", "scene/import", "scene/model", "scene/base", "collision"],
    "scene/frame": ["scene/suggest", "scene/lint", "scene/model", "scene/base", "collision"],
    "scene/suggest": ["scene/campus", "scene/lint", "scene/model", "scene/base", "collision"],
    # Where a body can get to: what the simulation's go_to and "why not" build on.
    **_rooms("engine/walkspace", ["stride", "space", "explore", "barrier", "route", "passage", "report"],
             ["engine/script", "engine/events", "scene", "collision"]),
    # The simulation core: it emits records and doesn't depend on their readers.
    "engine/events": ["scene", "collision"],
    "engine/script": ["engine/events", "scene", "collision"],
    "engine/record": ["engine/script", "engine/events", "scene", "collision"],
    "engine/expect": ["engine/walkspace", "engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/simulation": ["engine/walkspace", "engine/expect", "engine/record", "engine/script", "engine/events", "scene",
                          "collision"],
    "engine/observers": ["engine/expect", "engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/testing": ["engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/report": ["engine/simulation", "engine/expect", "engine/record", "engine/script", "engine/events", "scene",
                      "collision"],
    # What shows walks again is made of results, recordings and the campus.
    "engine/html_report": ["engine/report", "engine/script", "engine/events", "scene", "collision"],
    # Images are plain data: comparing them needs nothing that draws.
    "engine/render/image": ["engine/events", "scene", "collision"],
    "engine/render/compare": ["engine/render/image", "engine/script", "engine/events"],
    "engine/render/geometry": ["engine/record", "engine/script", "engine/events", "scene", "collision"],
    "engine/render/gl": ["engine/render/geometry", "engine/render/image", "scene", "collision"],
    "engine/render/passes": ["engine/render/gl", "engine/render/geometry", "engine/render/image", "engine/script",
                             "scene", "collision"],
    "engine/render/overlay": ["engine/render/gl", "engine/render/geometry", "engine/render/image", "engine/record",
                              "engine/script", "engine/events", "scene", "collision"],
    # Plans of the walk space are drawn without GL, from plain data.
    "engine/render/plan": ["engine/render/overlay", "engine/render/image"],
    "engine/render": ["engine/walkspace", "engine/record", "engine/script", "engine/events", "scene", "collision"],
    "config/loader/yaml": ["scene/base"],
    # Into the same tree as YAML.
    "config/loader/json": ["config/loader/yaml", "scene/base"],
    "config/loader/values": ["config/loader/yaml", "scene/base"],
    "config/loader/campus": ["config/loader/values", "config/loader/json", "config/loader/yaml", "engine/events", "scene"],
    "config/loader/profile": ["config/loader/values", "config/loader/yaml", "engine/script", "scene/base"],
    "config/loader/walk": ["config/loader/profile", "config/loader/values", "config/loader/yaml", "engine/script",
                           "engine/events", "scene", "collision"],
    "config/loader": ["engine/script", "scene"],
    "tools": [],
    "tools/campuswalk/base": _CORE,
    "tools/campuswalk/command_line": ["tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/loading": ["tools/campuswalk/command_line", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/logs": ["tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/images": ["tools/campuswalk/logs", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/run/workers": ["tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/run/plan": ["tools/campuswalk/suggest", "tools/campuswalk/images", "tools/campuswalk/loading", "tools/campuswalk/logs",
                                  "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/run/results": ["tools/campuswalk/run/plan", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/run/cases": ["tools/campuswalk/run/plan", "tools/campuswalk/run/workers", "tools/campuswalk/images",
                                   "tools/campuswalk/loading", "tools/campuswalk/logs", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/run/output": ["tools/campuswalk/run/cases", "tools/campuswalk/run/results", "tools/campuswalk/run/plan",
                                    "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/run/html": ["tools/campuswalk/run/output", "tools/campuswalk/run/results", "tools/campuswalk/run/plan",
                                  "tools/campuswalk/loading", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/run": ["tools/campuswalk/images", "tools/campuswalk/loading", "tools/campuswalk/logs",
                             "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/cluster": ["tools/campuswalk/run", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/collide": ["tools/campuswalk/loading", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/explore": ["tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/route": ["tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/completion": ["tools/campuswalk/command_line", "tools/campuswalk/base"],
    "tools/campuswalk/help": ["tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/import": ["tools/campuswalk/loading", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/init": ["tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/suggest": ["tools/campuswalk/loading", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk/validate": ["tools/campuswalk/run/plan", "tools/campuswalk/loading", "tools/campuswalk/base"] + _CORE,
    "tools/campuswalk": _CORE,
    # Other engines: of our code they see only their input and the interface that they implement.
    "tools/campuswalk_bench/peers": ["tools/campuswalk_bench/engine", "collision"],
    "tools/campuswalk_bench/engine": ["collision"],
    "tools/campuswalk_bench/engines": ["tools/campuswalk_bench/engine", "collision"],
    "tools/campuswalk_bench/files": ["scene", "collision"],
    "tools/campuswalk_bench/measure": ["engine", "scene", "collision"],
    "tools/campuswalk_bench/maps": ["scene", "collision"],
    "tools/campuswalk_bench/pairs": ["tools/campuswalk_bench/engine", "tools/campuswalk_bench/engines",
                                     "tools/campuswalk_bench/measure", "tools/campuswalk_bench/procedural", "engine",
                                     "scene", "collision"],
    "tools/campuswalk_bench/procedural": ["scene/model", "collision"],
    "tools/campuswalk_bench/trees": ["tools/campuswalk_bench/engine", "tools/campuswalk_bench/engines",
                                     "tools/campuswalk_bench/measure", "tools/campuswalk_bench/pairs", "scene", "collision"],
    "tools/campuswalk_bench": ["tools/campuswalk", "engine", "scene", "collision"],
    "tests": [ANYWHERE],
}

# Single files (named without .h or .cpp) that may include less than their folder. The oracle must share no
# function with what it checks: of collision/ it sees only the world's data.
_ORACLE = ["tests/support/penetration_oracle", "tests/support/plain_geometry", "tests/support/plain_solids",
           "tests/support/triangle_grid"]
STRICTER = {file: _ORACLE + ["collision/mesh/mesh_collider", "collision/geometry/shapes", "collision/geometry/triangle_mesh",
                             "collision/world/world"] for file in _ORACLE}

# Where third-party headers may be included; the longest matching prefix decides. Some are in a folder that an include
# may name or not: see OPTIONAL_PREFIXES.
THIRD_PARTY = {
    "Eigen/": [ANYWHERE],
    "hwy/": ["collision/bvh8/kernels"],
    "BulletCollision/BroadphaseCollision/": ["collision/world", "tools/campuswalk_bench/peers"],
    "LinearMath/": ["collision/world"],
    # Bullet's narrow phase, bodies and dynamics, which the hybrid trees replace.
    "BulletCollision/": ["tests", "tools/campuswalk_bench/peers"],
    "BulletDynamics/": ["tests", "tools/campuswalk_bench/peers"],
    "BulletSoftBody/": ["tests"],
    "btBulletCollisionCommon.h": ["tests"],
    "btBulletDynamicsCommon.h": ["tests"],
    "assimp/": ["scene/import", "tools/campuswalk_bench/peers"],
    "stb/": ["scene/import"],
    "utf8proc.h": ["scene/base", "tests/packed_walks/aarch64"],
    "xxhash.h": ["scene/base"],
    "nettle/": ["scene/cache"],
    "seccomp.h": ["scene/import/helper"],
    "linux/": ["scene/import/helper", "tests"],
    "draco/": ["scene/import/gltf", "tests/scene/import/gltf"],
    "meshoptimizer.h": ["scene/export", "scene/import/gltf", "tests/scene/import/gltf"],
    "turbojpeg.h": ["scene/import/source", "tests/scene/import/source"],
    "webp/": ["scene/export", "scene/import", "tests/scene/export", "tests/scene/import/gltf"],
    "nlohmann/": ["config/loader/json", "scene/export", "scene/import/gltf", "engine/observers", "engine/html_report", "engine/render/snapshot", "engine/report", "tools/campuswalk",
                  "tools/campuswalk_bench", "tests"],
    "osmium/": ["scene/osm"],
    "expat.h": ["scene/osm"],
    "geos_c.h": ["scene/osm", "tests/scene/osm", "tools/campuswalk_bench/maps"],
    "pugixml": ["engine/report", "scene/import/source"],
    "GL/": ["engine/render", "tests/engine/render"],
    "EGL/": ["engine/render"],
    "KHR/": ["engine/render"],
    "malloc.h": ["tools/campuswalk_bench"],
    "dlfcn.h": ["engine/render", "tools/campuswalk_bench"],
    "cairo": ["engine/render", "tests/engine/render", "tools/campuswalk_bench"],
    "fontconfig/": ["engine/render", "tests/engine/render"],
    "pango/": ["engine/render", "tests/engine/render"],
    "libdeflate.h": ["engine/render", "engine/html_report", "tests/engine/html_report"],
    "simdjson.h": ["engine/html_report"],
    "gif_lib.h": ["engine/render", "tests/engine/render"],
    "spng.h": ["engine/render", "tests/engine/render"],
    "yaml-cpp/": ["config/loader/yaml"],
    "CLI/": ["tools/campuswalk/command_line"],
    "fmt/": ["tools/campuswalk/base"],
    "spdlog/": ["tools/campuswalk/base"],
    "re2/": ["tools/campuswalk/run/plan"],
    "poll.h": ["scene/process", "tools/campuswalk/base", "tools/campuswalk/run"],
    "pthread.h": ["tools/campuswalk/run/results"],
    "spawn.h": ["scene/process"],
    "unistd.h": ["scene/base", "scene/cache", "scene/import", "scene/process", "tools/campuswalk", "tools/campuswalk_bench",
                 "tests"],
    "fcntl.h": ["scene/base", "scene/cache", "scene/import", "scene/process", "tools/campuswalk", "tests"],
    "sys/mman.h": ["collision/base", "scene/cache", "scene/import/helper", "tools/campuswalk/loading", "tests"],
    "sched.h": ["tests"],
    "sys/file.h": ["scene/base", "tests"],
    "sys/stat.h": ["config/loader/values", "scene/base", "scene/cache", "scene/import", "tests", "tools/campuswalk/run/output"],
    "sys/": ["scene/cache", "scene/import", "scene/process", "tools/campuswalk", "tools/campuswalk_bench", "tests"],
    "gtest/": ["tests"],
    "gmock/": ["tests", "engine/testing"],
    "doctest/": ["tests"],
    "CGAL/": ["tests", "tools/campuswalk_bench/peers"],
    "fcl/": ["tools/campuswalk_bench/peers"],
    "embree3/": ["tools/campuswalk_bench/peers"],
    "tbb/": ["tools/campuswalk_bench/peers"],
    "ode/": ["tools/campuswalk_bench/peers"],
    "recastnavigation/": ["tools/campuswalk_bench/peers"],
}
OPTIONAL_PREFIXES = ("bullet/", "eigen3/")

# Places whose results go into a walk's hash: no libm but sqrt and the exact functions, no clock, no random numbers.
SAME_EVERYWHERE = ["collision", "scene", "engine", "config/loader"]
# Of the cache, times decide whether a file is hashed again, never what is read.
MAY_DIFFER = ["scene/cache", "scene/export", "scene/import", "scene/process", "engine/render"]
REFUSED_STANDARD = {
    "chrono": "a walk knows no clock but its ticks",
    "ctime": "a walk knows no clock but its ticks",
    "random": "the standard's distributions differ between libraries",
    "complex": "it calls libm",
    "valarray": "it calls libm",
    "cfenv": "the rounding mode is the same everywhere",
    "thread": "a walk is one thread",
}

# Instruction sets are chosen only in kernel folders.
KERNEL_FOLDERS = ["collision/bvh8/kernels"]

# The one door to threads in what must be the same everywhere; without the file's ending.
THREAD_DOORS = ["engine/walkspace/stride/worker_threads"]

CODE_FOLDERS = ("collision", "scene", "engine", "config", "tools", "tests")


def place_of(path, places):
    """The longest of `places` that is `path` or a folder above it; None without one."""
    while path:
        if path in places:
            return path
        path = path.rpartition("/")[0]
    return None


def is_in(path, places):
    """Whether one of `places` is `path`, is above it, or is ANYWHERE."""
    return ANYWHERE in places or place_of(path, places) is not None


def needs_same_bits(path):
    """Whether what the file computes must be the same on every machine."""
    nearest = place_of(path, SAME_EVERYWHERE + MAY_DIFFER)
    return nearest in SAME_EVERYWHERE
