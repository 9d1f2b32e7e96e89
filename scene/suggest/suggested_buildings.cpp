#include "scene/suggest/suggested_buildings.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "scene/base/ascii.h"
#include "scene/base/glob.h"
#include "scene/base/unicode_words.h"
#include "scene/campus/object_names.h"
#include "scene/model/common_ancestor.h"
#include "scene/model/name_words.h"
#include "scene/suggest/find_buildings.h"
#include "scene/suggest/split_nodes.h"

namespace campuswalk::scene {

namespace {

using Eigen::Vector3d;

bool says_something(const std::string& name) {
    return !name.empty() && !is_generated_name(name) && !is_default_name(name) && !is_identifier(name);
}

/// Importers call a file's root `school.obj`.
std::string without_file_ending(const std::string& name) {
    for (const std::string_view ending :
         {".obj", ".dae", ".glb", ".gltf", ".fbx", ".ply", ".stl", ".blend", ".skp"}) {
        if (name.ends_with(ending)) {
            return name.substr(0, name.size() - ending.size());
        }
    }
    return name;
}

/// Whether nodes of several buildings are at each node or below it.
std::vector<bool> hold_several(const Model& model, const std::vector<FoundBuilding>& buildings) {
    std::vector<std::optional<std::size_t>> held(model.nodes.size());
    std::vector<bool> several(model.nodes.size(), false);
    const auto add = [&](std::size_t node, std::size_t building) {
        several[node] = several[node] || (held[node] && *held[node] != building);
        held[node] = building;
    };
    for (std::size_t b = 0; b < buildings.size(); ++b) {
        for (const std::size_t node : buildings[b].nodes) {
            add(node, b);
        }
    }
    for (std::size_t n = model.nodes.size(); n-- > 0;) {  // children first
        if (const int parent = model.nodes[n].parent; parent >= 0 && held[n]) {
            add(static_cast<std::size_t>(parent), *held[n]);
            several[static_cast<std::size_t>(parent)] =
                several[static_cast<std::size_t>(parent)] || several[n];
        }
    }
    return several;
}

/// Where the last word of the beginning is cut through, it is left out, as are marks and digits at the end.
std::string whole_words(std::string beginning, const std::string& one) {
    const auto is_word = [](char c) { return is_letter(c) || (static_cast<unsigned char>(c) & 0x80U) != 0; };
    if (beginning.size() < one.size() && is_word(one[beginning.size()]) && !is_upper(one[beginning.size()])) {
        while (!beginning.empty() && is_word(beginning.back())) {
            beginning.pop_back();
        }
    }
    while (!beginning.empty() && !is_word(beginning.back())) {
        beginning.pop_back();
    }
    return beginning;
}

/// What the names of most of the nodes begin with.
std::string shared_beginning(const Model& model, const std::vector<std::size_t>& nodes) {
    constexpr double kMost = 0.6;
    std::vector<std::string> names;
    for (const std::size_t node : nodes) {
        if (!is_generated_name(model.nodes[node].name)) {
            names.push_back(model.nodes[node].name);
        }
    }
    if (names.size() < 2) {
        return "";
    }
    std::ranges::sort(names);
    const auto wanted = static_cast<std::size_t>(kMost * static_cast<double>(names.size())) + 1;
    std::string best;
    for (std::size_t first = 0; first + wanted <= names.size(); ++first) {
        const std::string& a = names[first];
        const std::string& b = names[first + wanted - 1];
        const auto end = std::ranges::mismatch(a, b).in1;
        const std::string beginning = whole_words(std::string(a.begin(), end), a);
        if (beginning.size() > best.size()) {
            best = beginning;
        }
    }
    return best.size() >= 2 ? best : "";
}

/// All nodes of the subtrees; ascending.
std::vector<std::size_t> subtrees_of(const Model& model, const std::vector<std::size_t>& roots) {
    std::vector<bool> inside(model.nodes.size(), false);
    for (const std::size_t root : roots) {
        inside[root] = true;
    }
    std::vector<std::size_t> nodes;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const int parent = model.nodes[n].parent;
        inside[n] = inside[n] || (parent >= 0 && inside[static_cast<std::size_t>(parent)]);
        if (inside[n]) {
            nodes.push_back(n);
        }
    }
    return nodes;
}

std::vector<std::string> globs_of_building(const Model& model, const FoundBuilding& building,
                                           const std::map<std::string, std::size_t>& uses) {
    constexpr std::size_t kFew = 3;
    constexpr std::size_t kMany = 100;
    if (building.nodes.size() > kFew) {
        const std::string beginning = shared_beginning(model, building.nodes);
        const std::string glob = glob_for(beginning) + "*";
        if (!beginning.empty() && match_nodes(model, glob) == subtrees_of(model, building.nodes)) {
            return {glob};
        }
    }
    std::vector<std::string> globs;
    for (const std::size_t node : building.nodes) {
        const std::string& name = model.nodes[node].name;
        if (uses.at(name) == 1 && !is_generated_name(name)) {
            globs.push_back(glob_for(name));
        }
    }
    return globs.size() <= kMany ? globs : std::vector<std::string>{};
}

/// The name of the lowest node that says something, from this one up to the highest that holds no other
/// building and is no root without triangles, which an importer calls after the file.
std::string name_above(const Model& model, std::size_t node, const std::vector<bool>& several) {
    for (int group = static_cast<int>(node); group >= 0 && !several[static_cast<std::size_t>(group)];
         group = model.nodes[static_cast<std::size_t>(group)].parent) {
        const Node& each = model.nodes[static_cast<std::size_t>(group)];
        if (each.parent < 0 && each.meshes.empty()) {
            break;
        }
        if (std::string name = without_file_ending(each.name); says_something(name)) {
            return name;
        }
    }
    return "";
}

/// The name of the root that a node is below, unless that holds several buildings.
std::string name_of_root(const Model& model, std::size_t node, const std::vector<bool>& several) {
    while (model.nodes[node].parent >= 0) {
        node = static_cast<std::size_t>(model.nodes[node].parent);
    }
    return several[node] ? "" : without_file_ending(model.nodes[node].name);
}

/// The name of the building's widest node, of those that begin near its foot, rise to half of its height and
/// whose names don't say that they are a part of it.
std::string name_of_widest(const Model& model, const std::vector<NodeReport>& report,
                           const FoundBuilding& building) {
    constexpr double kLeast = 0.3;  // of the building's footprint
    constexpr double kFoot = 0.2;   // of its height
    const double foot = building.box.center.y() + (kFoot - 0.5) * building.box.size.y();
    double widest = kLeast * building.box.footprint();
    std::string best;
    for (const std::size_t node : building.nodes) {
        const std::string name = without_file_ending(model.nodes[node].name);
        const Vector3d size = report[node].bounds.max - report[node].bounds.min;
        if (size.x() * size.z() > widest && report[node].bounds.min.y() <= foot &&
            size.y() >= 0.5 * building.box.size.y() && says_something(name) && !is_building_part_name(name) &&
            !is_stairs_name(name) && !is_surroundings_name(name)) {
            widest = size.x() * size.z();
            best = name;
        }
    }
    return best;
}

/// What each building is called in the model: the name of its only node, that of the lowest group which holds
/// all of its nodes and of no other building, the beginning that the names of most of its nodes share, or the
/// name of its widest; of those, the first that says something (is_default_name, is_identifier, generated
/// names don't). If nothing does, empty. One name for each building.
std::vector<std::string> names_of(const Model& model, const std::vector<NodeReport>& report,
                                  const std::vector<FoundBuilding>& buildings) {
    const std::vector<bool> several = hold_several(model, buildings);
    std::vector<std::string> names;
    for (const FoundBuilding& building : buildings) {
        const auto group = common_ancestor(model, building.nodes);
        std::string name = group ? name_above(model, *group, several) : "";
        if (name.empty()) {
            name = shared_beginning(model, building.nodes);
        }
        if (!says_something(name)) {
            name = name_of_widest(model, report, building);
        }
        if (!says_something(name)) {
            name = group ? name_of_root(model, *group, several) : "";
        }
        names.push_back(says_something(name) ? name : "");
    }
    return names;
}

/// The buildings by the nodes of the original model: those that are a building's with all their pieces, or
/// hardly reach beyond it and have no piece in another.
std::vector<FoundBuilding> by_whole_nodes(const SplitModel& split, const std::vector<FoundBuilding>& found,
                                          const ModelReport& report) {
    constexpr double kMore = 1.5;                        // of the building's footprint
    constexpr double kYard = 20.0;                       // m²
    std::map<std::size_t, std::set<std::size_t>> users;  // by node of the original
    for (std::size_t b = 0; b < found.size(); ++b) {
        for (const std::size_t node : found[b].nodes) {
            users[split.node[node]].insert(b);
        }
    }
    std::vector<FoundBuilding> buildings;
    for (const FoundBuilding& each : found) {
        FoundBuilding& building = buildings.emplace_back(FoundBuilding{{}, each.box});
        for (const std::size_t node : each.nodes) {
            const std::size_t original = split.node[node];
            const bool is_piece = node > 0 && split.node[node - 1] == original;
            const Vector3d size = report.nodes[original].bounds.max - report.nodes[original].bounds.min;
            const bool is_own =
                users[original].size() == 1 && size.x() * size.z() <= kMore * each.box.footprint() + kYard;
            if ((!is_piece || is_own) &&
                std::ranges::find(building.nodes, original) == building.nodes.end()) {
                building.nodes.push_back(original);
            }
        }
    }
    return buildings;
}

/// Globs that match the nodes of each building, with their subtrees, and nothing else; none if the names
/// don't tell them from other nodes or there are over a hundred that share no beginning.
std::vector<std::vector<std::string>> globs_of(const Model& model,
                                               const std::vector<FoundBuilding>& buildings) {
    std::map<std::string, std::size_t> uses;
    for (const Node& node : model.nodes) {
        ++uses[node.name];
    }
    std::vector<std::vector<std::string>> globs;
    globs.reserve(buildings.size());
    for (const FoundBuilding& building : buildings) {
        globs.push_back(globs_of_building(model, building, uses));
    }
    return globs;
}

/// Leaves out all but the largest of those without a name, and returns how many.
std::size_t keep_largest_unnamed(std::vector<FoundBuilding>& buildings, std::vector<std::string>& names) {
    constexpr std::size_t kMostUnnamed = 40;
    std::vector<std::size_t> unnamed;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].empty()) {
            unnamed.push_back(i);
        }
    }
    std::ranges::stable_sort(unnamed, std::greater(),
                             [&](std::size_t i) { return buildings[i].box.footprint(); });
    unnamed.erase(unnamed.begin(),
                  unnamed.begin() + static_cast<std::ptrdiff_t>(std::min(kMostUnnamed, unnamed.size())));
    std::ranges::sort(unnamed, std::greater());
    for (const std::size_t i : unnamed) {
        buildings.erase(buildings.begin() + static_cast<std::ptrdiff_t>(i));
        names.erase(names.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return unnamed.size();
}

}  // namespace

SuggestedBuildings suggest_buildings(const Model& model, const ModelReport& report) {
    const SplitModel split = split_nodes(model);
    ModelReport pieces;
    pieces.bounds = report.bounds;
    pieces.nodes = split.report;
    std::vector<FoundBuilding> found = find_buildings(split.model, pieces);
    std::vector<std::string> names = names_of(split.model, split.report, found);
    if (found.size() == 1 && names[0].empty()) {
        names[0] = std::filesystem::path(model.file).stem().string();
    }
    const std::size_t left_out = keep_largest_unnamed(found, names);
    std::vector<std::string> words;
    words.reserve(names.size());
    std::size_t numbered = 0;
    for (std::string& name : names) {
        const std::string word = to_id_word(name);
        const std::string number = std::to_string(word.empty() ? ++numbered : numbered);
        words.push_back(word.empty() ? "building-" + number : word);
        if (name.empty()) {
            name = "Building " + number;
        }
    }
    const std::vector<std::string> ids = distinct_words(words);
    found = by_whole_nodes(split, found, report);
    const std::vector<std::vector<std::string>> globs = globs_of(model, found);
    SuggestedBuildings buildings{.list = {}, .left_out = left_out};
    for (std::size_t i = 0; i < found.size(); ++i) {
        buildings.list.push_back({ids[i], names[i], globs[i], found[i].nodes.size() == 1, found[i].box});
    }
    return buildings;
}

}  // namespace campuswalk::scene
