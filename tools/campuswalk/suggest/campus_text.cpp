#include "tools/campuswalk/suggest/campus_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/events/decimals.h"
#include "scene/model/name_words.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools {

using engine::fixed;

namespace {

/// JSON strings are YAML strings, too.
std::string quoted(const std::string& text) {
    return json_text(text);
}

std::string list_of(const Eigen::Vector3d& v) {
    return "[" + fixed(v.x(), 3) + ", " + fixed(v.y(), 3) + ", " + fixed(v.z(), 3) + "]";
}

std::string box_yaml(const scene::UprightBox& box) {
    const double yaw_deg = engine::degrees(std::atan2(-box.along.z(), box.along.x()));
    return "shape: box, center: " + list_of(box.center) + ", size: " + list_of(box.size) +
           (box.along.z() == 0.0 ? "" : ", yaw_deg: " + fixed(yaw_deg, 2));
}

std::string except_yaml(const std::vector<scene::NodeGlob>& doors) {
    std::vector<std::string> patterns;
    for (const scene::NodeGlob& door : doors) {
        patterns.push_back(quoted(door.pattern));
    }
    return patterns.empty() ? "" : ", except: [" + joined(patterns, ", ") + "]";
}

/// The node's name; Building 3 for `building-3` if the name is an identifier that nobody can read.
std::string title_of(const scene::SuggestedBuilding& building) {
    if (!scene::is_identifier(building.node)) {
        return building.node;
    }
    std::string title = building.id;
    std::ranges::replace(title, '-', ' ');
    title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    return title;
}

}  // namespace

scene::UprightBox trigger_about(const scene::SuggestedBuilding& building) {
    scene::UprightBox box = building.box;
    box.size += Eigen::Vector3d(3.0, 1.0, 3.0);
    return box;
}

std::string campus_yaml(const SuggestedCampus& campus) {
    std::string text =
        "# A first draft by `campuswalk info --suggest`: rename, describe, and split what is solid.\n"
        "scenes:\n  - {file: " +
        quoted(campus.model);
    text += campus.scene.up == scene::UpAxis::z ? ", up: z" : "";
    text += campus.scene.scale != 1.0 ? ", scale: " + json_text(campus.scene.scale) : "";
    text += "}\n";
    text += campus.origin.isZero(0.0) ? "" : "origin: {at: " + list_of(campus.origin) + "}\n";
    text += campus.buildings.empty() ? "" : "buildings:\n";
    for (const scene::SuggestedBuilding& building : campus.buildings) {
        text += "  - {id: " + quoted(building.id) + ", nodes: " + quoted(building.glob) +
                ", title: " + quoted(title_of(building)) + "}\n";
    }
    text += campus.doors.empty() ? "colliders:\n"
                                 : "colliders:\n  # Closed doors are left out: nobody could pass them.\n";
    text += "  - {id: world, nodes: \"*\"" + except_yaml(campus.doors) + ", shape: mesh, mode: solid}\n";
    if (campus.ground) {
        const scene::UprightBox box{campus.ground->center(), campus.ground->max - campus.ground->min,
                                    Eigen::Vector3d::UnitX()};
        text +=
            "  # The model has no ground. This box replaces it; pictures don't show it.\n"
            "  - {id: ground, " +
            box_yaml(box) + ", mode: solid}\n";
    }
    for (const scene::SuggestedBuilding& building : campus.buildings) {
        text += "  - {id: " + quoted(building.id + "/around") + ", building: " + quoted(building.id) + ", " +
                box_yaml(trigger_about(building)) + ", mode: trigger}\n";
    }
    return text + "spawns:\n  start: {at: " + list_of(campus.spawn) +
           ", yaw_deg: " + fixed(campus.yaw_deg, 1) + "}\n";
}

std::string walk_yaml(const SuggestedCampus& campus, const std::string& campus_file, std::size_t visits) {
    std::string steps = "  - spawn: start\n";
    std::string expect = "  - never: \"avatar.fell *\"\n";
    for (std::size_t v = 0; v < visits; ++v) {
        steps += "  - go_to: " + list_of(campus.visits[v].to) + "\n";
        if (!campus.visits[v].building.empty()) {
            expect +=
                "  - sequence: [" + quoted("trigger.enter " + campus.visits[v].building + "/around") + "]\n";
        }
    }
    return "# Beside " + campus_file + ", by `campuswalk info --suggest`.\ncampus: " + quoted(campus_file) +
           "\navatar: adult\nsteps:\n" + steps + (visits == 0 ? "  - wait: 1\n" : "") + "expect:\n" + expect;
}

}  // namespace campuswalk::tools
