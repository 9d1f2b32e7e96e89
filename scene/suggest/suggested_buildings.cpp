#include "scene/suggest/suggested_buildings.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "scene/campus/object_names.h"
#include "scene/suggest/building_names.h"
#include "scene/suggest/find_buildings.h"

namespace campuswalk::scene {
namespace {

/// Drops the accents of Latin letters and all other non-ASCII characters.
std::string to_ascii(const std::string& name) {
    constexpr std::string_view kPlain =
        "AAAAAAACEEEEIIIIDNOOOOO OUUUUYTsaaaaaaaceeeeiiiidnooooo ouuuuyty";  // U+00C0 to U+00FF
    std::string ascii;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto byte = static_cast<unsigned char>(name[i]);
        if (byte < 0x80U) {
            ascii += name[i];
        } else if (byte == 0xC3U && i + 1 < name.size()) {
            ascii += kPlain[static_cast<unsigned char>(name[++i]) & 0x3FU];
        }
    }
    return ascii;
}

bool has_letter(const std::string& ascii) {
    return std::ranges::any_of(ascii,
                               [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
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
    std::size_t numbered = 0;
    for (std::string& name : names) {
        const bool named = !name.empty();
        const std::string ascii = to_ascii(name);
        const std::string number = std::to_string(has_letter(ascii) ? numbered : ++numbered);
        words.push_back(has_letter(ascii) ? ascii : "building-" + number);
        name = named ? name : "Building " + number;
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
