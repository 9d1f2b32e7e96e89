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
#include "scene/model/name_words.h"
#include "scene/suggest/find_buildings.h"

namespace campuswalk::scene {

namespace {

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

/// From the node to its root.
std::vector<std::size_t> chain_of(const Model& model, std::size_t node) {
    std::vector<std::size_t> chain = {node};
    while (model.nodes[chain.back()].parent >= 0) {
        chain.push_back(static_cast<std::size_t>(model.nodes[chain.back()].parent));
    }
    return chain;
}

/// How many buildings have nodes below each node.
std::vector<std::size_t> buildings_below(const Model& model, const std::vector<FoundBuilding>& buildings) {
    std::vector<std::size_t> count(model.nodes.size(), 0);
    for (const FoundBuilding& building : buildings) {
        std::set<std::size_t> above;
        for (const std::size_t node : building.nodes) {
            const std::vector<std::size_t> chain = chain_of(model, node);
            above.insert(chain.begin(), chain.end());
        }
        for (const std::size_t node : above) {
            ++count[node];
        }
    }
    return count;
}

/// The lowest group that holds all nodes.
std::optional<std::size_t> common_group(const Model& model, const std::vector<std::size_t>& nodes) {
    std::vector<std::size_t> common = chain_of(model, nodes.front());
    for (const std::size_t node : nodes) {
        const std::vector<std::size_t> chain = chain_of(model, node);
        std::erase_if(common,
                      [&](std::size_t each) { return std::ranges::find(chain, each) == chain.end(); });
    }
    return common.empty() ? std::nullopt : std::optional(common.front());
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

/// What each building is called in the model: the name of its only node, that of the lowest group which holds
/// all of its nodes and of no other building, or the beginning that the names of most of its nodes share.
/// Empty if those say nothing (is_default_name, is_identifier, generated names). One name for each building.
std::vector<std::string> names_of(const Model& model, const std::vector<FoundBuilding>& buildings) {
    const std::vector<std::size_t> below = buildings_below(model, buildings);
    std::vector<std::string> names;
    for (const FoundBuilding& building : buildings) {
        const auto group = common_group(model, building.nodes);
        const std::string group_name =
            group && below[*group] == 1 ? without_file_ending(model.nodes[*group].name) : "";
        const std::string beginning = shared_beginning(model, building.nodes);
        const bool is_file = group && model.nodes[*group].parent < 0 && model.nodes[*group].meshes.empty();
        const std::string& first = is_file ? beginning : group_name;
        const std::string& second = is_file ? group_name : beginning;
        names.push_back(says_something(first) ? first : says_something(second) ? second : "");
    }
    return names;
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

/// Leaves out all but the largest of those without a name.
void keep_largest_unnamed(std::vector<FoundBuilding>& buildings, std::vector<std::string>& names) {
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
}

}  // namespace

std::vector<SuggestedBuilding> suggest_buildings(const Model& model, const ModelReport& report) {
    std::vector<FoundBuilding> found = find_buildings(model, report);
    std::vector<std::string> names = names_of(model, found);
    if (found.size() == 1 && names[0].empty()) {
        names[0] = std::filesystem::path(model.file).stem().string();
    }
    keep_largest_unnamed(found, names);
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
    const std::vector<std::vector<std::string>> globs = globs_of(model, found);
    std::vector<SuggestedBuilding> buildings;
    for (std::size_t i = 0; i < found.size(); ++i) {
        buildings.push_back({ids[i], names[i], globs[i], found[i].nodes.size() == 1, found[i].box});
    }
    return buildings;
}

}  // namespace campuswalk::scene
