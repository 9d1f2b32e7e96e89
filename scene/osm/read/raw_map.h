#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

// What OpenStreetMap's database allows (https://api.openstreetmap.org/api/0.6/capabilities); what exceeds it
// was made by hand, and geometry made from it could take any time.
inline constexpr std::size_t kMaxWayNodes = 2'000;
inline constexpr std::size_t kMaxMembers = 32'000;
inline constexpr std::size_t kMaxTextCharacters = 255;  ///< of a key or a value

/// Nodes of a map that is read at once.
inline constexpr std::size_t kMaxMapNodes = 20'000'000;

/// Where a node is: degrees times 10^7, as the database has them.
struct NodeLocation {
    std::int64_t id = 0;
    std::int32_t longitude_e7 = 0;
    std::int32_t latitude_e7 = 0;

    double longitude() const { return longitude_e7 / 1e7; }
    double latitude() const { return latitude_e7 / 1e7; }
};

/// The elements of a file, in degrees.
struct RawMap {
    std::vector<NodeLocation> locations;               ///< by id
    std::vector<std::pair<std::int64_t, Tags>> nodes;  ///< with tags, in the file's order
    std::vector<MapWay> ways;                          ///< likewise, without points
    std::vector<MapRelation> relations;                ///< multipolygons and buildings
    std::size_t bad_locations = 0;                     ///< nodes without valid coordinates, left out
    std::vector<ElementId> oversized;                  ///< beyond the limits above, left out
    std::vector<ElementId> ambiguous;                  ///< different in the file with one version

    const NodeLocation* location(std::int64_t id) const {
        const auto found = std::ranges::lower_bound(locations, id, {}, &NodeLocation::id);
        return found != locations.end() && found->id == id ? &*found : nullptr;
    }
};

/// What the file says about its extent; none if nothing. Throws as read_raw_map.
std::optional<GeographicBox> stated_bounds(const std::filesystem::path& file, const SourceMark& mark);

/// Reads OpenStreetMap XML or PBF; the name of `mark` says which. With a box only nodes in it are kept, and
/// whole ways and areas that overlap it: a file of a country takes no more memory than a city then, but is
/// read three times. A file with repeated elements is read again. Throws InputError at `mark`: bad-map
/// (damaged, or no map), bad-size (too many nodes).
RawMap read_raw_map(const std::filesystem::path& file, const SourceMark& mark,
                    const std::optional<GeographicBox>& box);

}  // namespace campuswalk::scene::osm
