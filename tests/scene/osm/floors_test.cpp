#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/osm/imported_map.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

/// What is above, below and inside of buildings.
class Floors : public ImportMap {
protected:
    static std::string message_of(const ImportedMap& imported, const std::string& code) {
        for (const Diagnostic& warning : imported.warnings) {
            if (warning.code == code) {
                return warning.message;
            }
        }
        return "";
    }
    /// A building of 9 m over 40 m by 40 m.
    ImportedMap with_way(const MapText::Points& line, const MapText::Tags& tags,
                         const MapText::Tags& building = {{"building", "yes"}}) {
        MapText map;
        MapText::Tags all = building;
        all.emplace_back("height", "9");
        hall_ = "building/way-" + std::to_string(map.rectangle(-20, -20, 20, 20, all));
        way_ = map.way(line, tags);
        map.way({{-60, -40}, {60, -40}}, {{"highway", "footway"}});
        return import(map.xml());
    }

    std::string hall_;
    std::int64_t way_ = 0;
};

constexpr double kWhole = 1600.0 * 9.0;

TEST_F(ImportMap, BuildsBuildingsOnNegativeLayersThatStandAboveTheGround) {
    for (const char* key : {"height", "building:levels", "building"}) {
        MapText map;
        MapText::Tags tags = {{"building", "college"}, {"layer", "-1"}, {"name", "Elm Hall"}};
        tags.emplace_back(key, "5");
        const auto id = map.rectangle(-10, -10, 10, 10, tags);
        map.way({{-60, -40}, {60, -40}}, {{"highway", "footway"}});
        const ImportedMap imported = import(map.xml());
        const bool high = std::string(key) != "building";
        EXPECT_EQ(find(imported.model, "building/way-" + std::to_string(id)) != nullptr, high) << key;
        const auto warning = std::ranges::find(imported.warnings, "underground-building", &Diagnostic::code);
        ASSERT_EQ(warning == imported.warnings.end(), high) << key;
        if (!high) {
            EXPECT_TRUE(warning->message.starts_with("way-" + std::to_string(id) + " (Elm Hall) "));
        }
    }
}

TEST_F(ImportMap, NamesBuildingsAndPartsBelowTheGround) {
    const std::vector<MapText::Tags> below = {
        {{"building", "yes"}, {"location", "underground"}, {"height", "5"}},
        {{"building", "parking"}, {"parking", "underground"}},
        {{"building", "yes"}, {"level", "-1"}},
        {{"building", "yes"}, {"building:levels", "0"}, {"building:levels:underground", "2"}},
        {{"building:part", "yes"}, {"location", "underground"}},
        {{"building:part", "yes"}, {"layer", "-2"}}};
    for (const MapText::Tags& tags : below) {
        MapText map;
        const auto id = map.rectangle(-10, -10, 10, 10, tags);
        map.way({{-60, -40}, {60, -40}}, {{"highway", "footway"}});
        const ImportedMap imported = import(map.xml());
        EXPECT_EQ(find(imported.model, "building/way-" + std::to_string(id)), nullptr);
        EXPECT_EQ(std::ranges::count(imported.warnings, "underground-building", &Diagnostic::code), 1)
            << tags.back().first;
    }
}

}  // namespace
}  // namespace campuswalk::scene::osm
