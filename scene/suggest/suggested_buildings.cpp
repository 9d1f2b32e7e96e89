#include "scene/suggest/suggested_buildings.h"

#include <algorithm>
#include <filesystem>

#include "scene/base/unicode_words.h"
#include "scene/campus/object_names.h"
#include "scene/suggest/building_names.h"
#include "scene/suggest/find_buildings.h"

namespace campuswalk::scene {
namespace {

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
