#include "tools/campuswalk/suggest/campus_text.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/events/decimals.h"
#include "scene/base/utf8.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/yaml_text.h"

namespace campuswalk::tools {

using engine::fixed;

namespace {

std::string list_of(const Eigen::Vector3d& v) {
    return "[" + fixed(v.x(), 3) + ", " + fixed(v.y(), 3) + ", " + fixed(v.z(), 3) + "]";
}

/// Of the campus's [0, 0, 0]; empty if that is the model's and nowhere on the Earth.
std::string origin_yaml(const SuggestedCampus& campus) {
    std::string keys = campus.origin.isZero(0.0) ? "" : ", at: " + list_of(campus.origin);
    if (campus.on_earth) {
        keys += ", latitude_deg: " + fixed(campus.on_earth->latitude_deg, 9) +
                ", longitude_deg: " + fixed(campus.on_earth->longitude_deg, 9);
        keys += campus.on_earth->height == 0.0 ? "" : ", height: " + fixed(campus.on_earth->height, 3);
    }
    return keys.empty() ? "" : "origin: {" + keys.substr(2) + "}\n";
}

/// What has to be asked, as comments.
std::string doubts_yaml(const SuggestedCampus& campus) {
    std::string text;
    for (const scene::ModelLint& doubt : campus.doubts) {
        text += "  # To be decided: " + doubt.message + ".\n";
    }
    return text;
}

std::string spawn_yaml(const std::string& name, const Eigen::Vector3d& at, double yaw_deg) {
    return "  " + name + ": {at: " + list_of(at) + ", yaw_deg: " + fixed(yaw_deg, 1) + "}\n";
}

std::string spawns_yaml(const SuggestedCampus& campus) {
    std::string text = "spawns:\n" + spawn_yaml("start", campus.spawn, campus.yaw_deg);
    for (std::size_t i = 0; i < campus.more_spawns.size(); ++i) {
        const SuggestedSpawn& spawn = campus.more_spawns[i];
        text += "  # On " + fixed(spawn.area, 0) + " m² of ground that isn't reached from `start`.\n" +
                spawn_yaml(more_spawn_name(i), spawn.at, spawn.yaw_deg);
    }
    return text;
}

/// Nothing without a file of places.
std::string places_yaml(const SuggestedCampus& campus) {
    if (!campus.places) {
        return "";
    }
    const std::string path = yaml_string(campus.places->path.generic_string());
    const std::string& name = campus.places->name_property;
    return "places:\n  from: " +
           (name == config::PlaceFile().name_property
                ? path
                : "{file: " + path + ", name: " + yaml_string(name) + "}") +
           "\n";
}

std::string box_yaml(const scene::UprightBox& box) {
    const double yaw_deg = engine::degrees(std::atan2(-box.along.z(), box.along.x()));
    return "shape: box, center: " + list_of(box.center) + ", size: " + list_of(box.size) +
           (box.along.z() == 0.0 ? "" : ", yaw_deg: " + fixed(yaw_deg, 2));
}

std::string except_yaml(const std::vector<std::string>& globs) {
    return globs.empty() ? "" : ", except: " + globs_yaml(globs);
}

/// What stops the visitor: each building and each other part by itself, so that the log names it.
std::string solids_yaml(const SuggestedCampus& campus) {
    std::string text;
    std::vector<std::string> told = campus.left_out;
    for (std::size_t b = 0; b < campus.buildings.size(); ++b) {
        const scene::SuggestedBuilding& building = campus.buildings[b];
        if (!building.globs.empty()) {
            text += "  - {id: " + yaml_string(building.id) + ", building: " + yaml_string(building.id) +
                    except_yaml(campus.left_out_of[b]) + (building.is_one_node ? "" : ", each: true") +
                    ", shape: mesh, mode: solid, popup: false}\n";
            told.insert(told.end(), building.globs.begin(), building.globs.end());
        }
    }
    if (!campus.solids.globs.empty()) {
        text +=
            "  - {id: part, nodes: " +
            (campus.solids.are_the_rest ? yaml_string("*") + except_yaml(told)
                                        : globs_yaml(campus.solids.globs) + except_yaml(campus.left_out)) +
            ", each: true, shape: mesh, mode: solid}\n";
        told.insert(told.end(), campus.solids.globs.begin(), campus.solids.globs.end());
    }
    if (!campus.solids.is_all) {
        text += "  - {id: world, nodes: \"*\"" + except_yaml(told) + ", shape: mesh, mode: solid}\n";
    }
    return text;
}

/// A node's name may have characters that no title has: each run of them becomes a space.
std::string title_of(const scene::SuggestedBuilding& building) {
    std::string title;
    bool gap = false;
    for (std::string_view rest = building.title; !rest.empty();) {
        const std::size_t bytes = scene::utf8_length(rest, 0);
        const bool is_shown = bytes > 0 && !scene::controls_display(scene::code_point(rest.substr(0, bytes)));
        if (is_shown) {
            title += gap && !title.empty() ? " " : "";
            title += rest.substr(0, bytes);
        }
        gap = !is_shown;
        rest.remove_prefix(std::max<std::size_t>(1, bytes));
    }
    return title.empty() ? building.id : title;
}

}  // namespace

std::optional<scene::UprightBox> trigger_inside(const scene::SuggestedBuilding& building) {
    constexpr double kWall = 0.6;  // metres on either side
    constexpr double kRoom = 1.0;  // metres
    scene::UprightBox box = building.box;
    box.size -= Eigen::Vector3d(2.0 * kWall, 0.0, 2.0 * kWall);
    return std::min(box.size.x(), box.size.z()) >= kRoom ? std::optional(box) : std::nullopt;
}

collision::Aabb box_about(const scene::UprightBox& box) {
    const Eigen::Vector3d half =
        (0.5 * box.size.x() * box.along.cwiseAbs() + 0.5 * box.size.z() * box.across().cwiseAbs()) +
        Eigen::Vector3d(0.0, 0.5 * box.size.y() + kWaist, 0.0);
    return {box.center - half, box.center + half};
}

scene::UprightBox trigger_about(const scene::SuggestedBuilding& building) {
    scene::UprightBox box = building.box;
    box.size += Eigen::Vector3d(3.0, 1.0, 3.0);
    return box;
}

std::string more_spawn_name(std::size_t index) {
    return "start-" + std::to_string(index + 2);
}

std::string room_trigger(std::size_t room) {
    return "/room-" + std::to_string(room + 1);
}

std::string campus_yaml(const SuggestedCampus& campus) {
    std::string text =
        "# A first draft by campuswalk: rename, describe, and split what is solid.\n"
        "scenes:\n" +
        doubts_yaml(campus) + "  - {file: " + yaml_string(campus.model);
    text += campus.scene.up == scene::UpAxis::z ? ", up: z" : "";
    text += campus.scene.scale != 1.0 ? ", scale: " + json_text(campus.scene.scale) : "";
    text += "}\n";
    text += origin_yaml(campus);
    text += campus.buildings.empty() ? "" : "buildings:\n";
    text += campus.more_buildings == 0
                ? ""
                : "  # And " + std::to_string(campus.more_buildings) + " smaller ones without names.\n";
    for (const scene::SuggestedBuilding& building : campus.buildings) {
        text += "  - {id: " + yaml_string(building.id) +
                (building.globs.empty() ? "" : ", nodes: " + globs_yaml(building.globs)) +
                ", title: " + yaml_string(title_of(building)) + "}\n";
    }
    text += "colliders:\n";
    text += campus.closed_doors > 0 ? "  # Closed doors are left out: nobody could pass them.\n" : "";
    text += campus.left_out.size() > campus.closed_doors
                ? "  # Left out, too: skies, water, and what openings were cut with.\n"
                : "";
    text += solids_yaml(campus);
    if (campus.ground) {
        const scene::UprightBox box{campus.ground->center(), campus.ground->max - campus.ground->min,
                                    Eigen::Vector3d::UnitX()};
        text +=
            "  # The model has no ground. This box replaces it; pictures don't show it.\n"
            "  - {id: ground, " +
            box_yaml(box) + ", mode: solid}\n";
    }
    for (std::size_t b = 0; b < campus.buildings.size(); ++b) {
        const scene::SuggestedBuilding& building = campus.buildings[b];
        const auto add_trigger = [&](const std::string& name, const scene::UprightBox& box,
                                     const char* more) {
            text += "  - {id: " + yaml_string(building.id + name) +
                    ", building: " + yaml_string(building.id) + ", " + box_yaml(box) + ", mode: trigger" +
                    more + "}\n";
        };
        add_trigger(kAroundTrigger, trigger_about(building), "");
        const std::optional<scene::UprightBox> inside = trigger_inside(building);
        if (inside && campus.interiors[b].can_be_entered) {
            add_trigger(kInsideTrigger, *inside, ", popup: false");
        }
        for (std::size_t r = 0; r < campus.interiors[b].rooms.size(); ++r) {
            add_trigger(room_trigger(r), campus.interiors[b].rooms[r], ", popup: false");
        }
    }
    return text + spawns_yaml(campus) + places_yaml(campus);
}

bool enters_something(const SuggestedCampus& campus, std::size_t visits) {
    const auto first = campus.visits.begin();
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(visits), [](const SuggestedVisit& visit) {
        return !visit.trigger.empty() && !visit.trigger.ends_with(kAroundTrigger);
    });
}

std::string crowded_text(const SuggestedCampus& campus) {
    return campus.most_triangles ? "crowded places, with over " + fixed(*campus.most_triangles, 0) +
                                       " triangles within 2 m, weren't tried"
                                 : "";
}

std::string closing_text(const SuggestedDoorway& doorway) {
    return "the doorway at " + list_of(doorway.at) + ", " + fixed(doorway.width, 2) + " m wide, leaves " +
           (doorway.is_only_path ? "no path of up to " + fixed(kFarthestVisit, 0) + " m" : "another path");
}

std::string walk_yaml(const SuggestedCampus& campus, const std::string& campus_file, std::size_t visits) {
    std::string steps = "  - spawn: start\n";
    std::string expect = "  - never: \"avatar.fell *\"\n";
    for (std::size_t v = 0; v < visits; ++v) {
        const SuggestedVisit& visit = campus.visits[v];
        const auto doorway = std::ranges::find(campus.doorways, v, &SuggestedDoorway::visit);
        if (doorway != campus.doorways.end()) {
            steps += "  # Closing " + closing_text(*doorway) + ".\n";
        }
        steps += "  - go_to: " + (visit.place.empty() ? list_of(visit.to) : yaml_string(visit.place)) + "\n";
        if (!visit.trigger.empty()) {
            expect += "  - sequence: [" + yaml_string("trigger.enter " + visit.trigger) + "]\n";
        }
        expect += visit.place.empty() ? "" : "  - reaches: " + yaml_string(visit.place) + "\n";
    }
    expect += campus.at_most ? "  - duration: {at_most: " + std::to_string(*campus.at_most) + "}\n" : "";
    return "# Beside " + campus_file + ", by campuswalk.\n" +
           (enters_something(campus, visits)
                ? ""
                : "# It goes through no door: no building was found that can be entered from the spawn.\n") +
           (campus.ground ? "# The visitor walks on the box `ground` of that file: the model has no ground.\n"
                          : "") +
           (campus.starts_aside
                ? "# The visitor starts above rooms, perhaps on a roof: nothing else was found to stand on.\n"
                : "") +
           (campus.most_triangles ? "# To save time, " + crowded_text(campus) + ".\n" : "") +
           "campus: " + yaml_string(campus_file) + "\navatar: adult\nsteps:\n" + steps +
           (visits == 0 ? "  - wait: 1\n" : "") + "expect:\n" + expect;
}

}  // namespace campuswalk::tools
