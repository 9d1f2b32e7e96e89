#include "tools/campuswalk/init/templates.h"

#include <utility>

#include "tools/campuswalk/base/schemas.h"

namespace campuswalk::tools::init {

namespace {

constexpr const char* kCampus = R"(# yaml-language-server: $schema=schema/campus.schema.json
# A small school. 'campuswalk info school.obj' lists its nodes.
scenes:
  - file: school.obj
layers: [ground, furniture]
buildings:
  - {id: library, nodes: "library_*", kind: library, title: Main Library, hours: "08-22",
     floors: 1, text: Books and one desk.}
colliders:
  - {id: ground, nodes: terrain, shape: mesh, mode: solid, layer: ground, popup: false}
  - {id: library/walls, building: library, nodes: library_walls, shape: mesh,
     mode: [solid, ray], popup: false}
  - {id: library/desk, nodes: library_desk, shape: box, mode: solid, layer: furniture}
  - {id: library/door, building: library, shape: box, center: [0, 1.2, -6],
     size: [2, 2.4, 1], mode: trigger}
)";

constexpr const char* kStairs = R"(  - {id: stairs, nodes: stairs, shape: mesh, mode: solid, layer: ground}
  - {id: gallery, nodes: gallery, shape: mesh, mode: solid, layer: ground}
  - {id: gallery/top, shape: box, center: [11, 2.9, -2], size: [2, 2.4, 2], mode: trigger}
)";

constexpr const char* kHalls = R"(  - {id: cafeteria/walls, nodes: cafeteria_walls, shape: mesh, mode: solid}
  - {id: cafeteria/door, shape: box, center: [-16, 1.2, -4], size: [2, 2.4, 1], mode: trigger}
  - {id: gym/walls, nodes: gym_walls, shape: mesh, mode: solid}
  - {id: gym/door, shape: box, center: [18, 1.2, -8], size: [2, 2.4, 1], mode: trigger}
  - {id: bench, nodes: "bench_*", each: true, shape: box, mode: solid, layer: furniture}
)";

constexpr const char* kPlaces = R"(spawns:
  gate: {at: [0, 0, 15]}
places:
  library-door: [0, 0, -6]
  desk: [0, 0, -10.5]
)";

constexpr const char* kStairPlaces = R"(  stairs-foot: [11, 0, 5]
  gallery: [11, 1.7, -1.5]
)";

constexpr const char* kHallPlaces = R"(  square: [0, 0, 2]
  cafeteria: [-16, 0, -8]
  cafeteria-front: [-16, 0, 0]
  gym: [18, 0, -12]
  gym-front: [18, 0, -5]
)";

constexpr const char* kVisit = R"(# yaml-language-server: $schema=../schema/walk.schema.json
# From the gate, through the library's door, to the desk.
campus: ../school.campus.yaml
avatar: adult
steps:
  - spawn: gate
  - walk_to: library-door
  - walk_to: desk
expect:
  - sequence: [trigger.enter library/door, popup.open library]
  - never: "collision.enter library/walls"
  - never: avatar.fell
  - reaches: desk
)";

constexpr const char* kWall = R"(# yaml-language-server: $schema=../schema/walk.schema.json
# Nobody can walk through a wall. A walk that must fail is xfail, and can list the failures it must have.
campus: ../school.campus.yaml
avatar: adult
status: {is: xfail, because: the wall is solid, failures: [blocked]}
steps:
  - spawn: gate
  - walk_to: [3, -10]
)";

constexpr const char* kRobotUpstairs = R"(# yaml-language-server: $schema=../schema/walk.schema.json
# The robot stays at the foot of the stairs.
campus: ../school.campus.yaml
avatar: robot
steps:
  - spawn: gate
  - walk_to: stairs-foot
  - walk_to: {to: gallery, if_blocked: continue}
expect:
  - blocked_by: stairs
  - not: {reaches: gallery}
)";

constexpr const char* kUpstairs = R"(# yaml-language-server: $schema=../schema/walk.schema.json
# Up ten steps of 17 cm to the gallery.
campus: ../school.campus.yaml
avatar: adult
steps:
  - spawn: gate
  - walk_to: stairs-foot
  - walk_to: gallery
expect:
  - sequence: [trigger.enter gallery/top, avatar.arrive gallery]
  - never: avatar.fell
)";

constexpr const char* kRound = R"(# yaml-language-server: $schema=../schema/walk.schema.json
# To the cafeteria, the gym and the library, around the benches.
campus: ../school.campus.yaml
avatar: adult
steps:
  - spawn: gate
  - follow: [[0, 10], square]
  - walk_to: cafeteria-front
  - walk_to: cafeteria
  - walk_to: cafeteria-front
  - walk_to: square
  - walk_to: [8, -5]
  - walk_to: gym-front
  - walk_to: gym
expect:
  - sequence: [trigger.enter cafeteria/door, trigger.exit cafeteria/door, trigger.enter gym/door]
  - never: "collision.enter *"
  - reaches: gym
)";

constexpr const char* kConfig = R"(# yaml-language-server: $schema=schema/walks-config.schema.json
# Settings of 'campuswalk run' in this folder.
walks: walks
output: out
)";

constexpr const char* kAdult = R"(# yaml-language-server: $schema=../schema/avatar.schema.json
height: 1.8
radius: 0.3
eye_height: 1.65
speed: 1.4
step_height: 0.3
)";

constexpr const char* kRobot = R"(# yaml-language-server: $schema=../schema/avatar.schema.json
# Climbs kerbs but not stairs.
height: 0.7
radius: 0.3
eye_height: 0.5
speed: 1.2
step_height: 0.1
max_slope_deg: 15
)";

std::string campus_yaml(Template which) {
    const bool stairs = which != Template::minimal;
    const bool halls = which == Template::campus;
    return std::string(kCampus) + (stairs ? kStairs : "") + (halls ? kHalls : "") + kPlaces +
           (stairs ? kStairPlaces : "") + (halls ? kHallPlaces : "");
}

}  // namespace

std::vector<NewFile> files_of(Template which) {
    if (which == Template::none) {
        return {};
    }
    const SchoolModel model = school(which);
    std::vector<NewFile> files = {{"school.obj", model.obj},
                                  {"school.mtl", model.mtl},
                                  {"school.campus.yaml", campus_yaml(which)},
                                  {"avatars/adult.avatar.yaml", kAdult},
                                  {"walks/visit.walk.yaml", kVisit},
                                  {"walks/wall.walk.yaml", kWall}};
    if (which != Template::minimal) {
        files.push_back({"avatars/robot.avatar.yaml", kRobot});
        files.push_back({"walks/upstairs.walk.yaml", kUpstairs});
        files.push_back({"walks/robot-upstairs.walk.yaml", kRobotUpstairs});
    }
    if (which == Template::campus) {
        files.push_back({"walks/round.walk.yaml", kRound});
    }
    for (NewFile& file : settings_files()) {
        files.push_back(std::move(file));
    }
    return files;
}

std::vector<NewFile> settings_files() {
    std::vector<NewFile> files = {{"walks.config.yaml", kConfig},
                                  {kGitIgnore, "out/\nreport.html\n.campuswalk/\n"}};
    for (const EmbeddedSchema& schema : embedded_schemas()) {
        files.push_back({kSchemaFolder + std::string(schema.name), std::string(schema.text)});
    }
    return files;
}

}  // namespace campuswalk::tools::init
