#include "tools/campuswalk/explore/geojson.h"

#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/walkspace/space/node_numbers.h"
#include "scene/model/projection.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools::explore {

using collision::Vec3;

namespace {

/// A cell of side 1 with its lower left vertex there.
using UnitCell = std::pair<int, int>;

/// Vertices, the first one again at the end; only where the direction changes.
using Ring = std::vector<std::pair<int, int>>;

/// Cells that are joined by their sides: the outer ring counter-clockwise, then the holes, clockwise.
using CellPolygon = std::vector<Ring>;

/// East, north, west, south: the sides of a cell from its lower left vertex on, and the cells beyond them.
struct Side {
    UnitCell from;  ///< of the cell's vertices
    UnitCell beyond;
};
constexpr std::array<Side, 4> kSides{
    {{{0, 0}, {0, -1}}, {{1, 0}, {1, 0}}, {{1, 1}, {0, 1}}, {{0, 1}, {-1, 0}}}};
constexpr std::array<UnitCell, 4> kDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

UnitCell plus(const UnitCell& a, const UnitCell& b) {
    return {a.first + b.first, a.second + b.second};
}

/// Follows the sides of cells that have no neighbour there, with the cells to the left.
class Outlines {
public:
    explicit Outlines(const std::set<UnitCell>& cells) : cells_(cells) {
        for (const UnitCell& cell : cells) {
            for (std::size_t side = 0; side < 4; ++side) {
                if (!cells.contains(plus(cell, kSides[side].beyond))) {
                    sides_[plus(cell, kSides[side].from)].set(side);
                }
            }
        }
    }

    std::vector<CellPolygon> polygons() {
        label_parts();
        std::vector<CellPolygon> polygons(parts_);
        // From the lowest vertex on, each part's outer ring comes before its holes.
        for (auto vertex = sides_.begin(); vertex != sides_.end(); ++vertex) {
            for (std::size_t side = 0; side < 4; ++side) {
                if (vertex->second.test(side)) {
                    const std::size_t part = part_of_.at(left_of(vertex->first, side));
                    polygons[part].push_back(ring_from(vertex->first, side));
                }
            }
        }
        return polygons;
    }

private:
    void label_parts() {
        for (const UnitCell& first : cells_) {
            if (part_of_.contains(first)) {
                continue;
            }
            std::vector<UnitCell> open{first};
            part_of_[first] = parts_;
            while (!open.empty()) {
                const UnitCell cell = open.back();
                open.pop_back();
                for (const Side& side : kSides) {
                    const UnitCell beside = plus(cell, side.beyond);
                    if (cells_.contains(beside) && part_of_.emplace(beside, parts_).second) {
                        open.push_back(beside);
                    }
                }
            }
            ++parts_;
        }
    }

    static UnitCell left_of(const UnitCell& vertex, std::size_t side) {
        return {vertex.first - kSides[side].from.first, vertex.second - kSides[side].from.second};
    }

    /// Takes the sides of the ring away. Where two cells touch at a vertex, it stays with its own.
    Ring ring_from(const UnitCell& start, std::size_t direction) {
        Ring ring;
        UnitCell at = start;
        std::size_t before = 4;
        while (true) {
            std::bitset<4>& here = sides_[at];
            if (before < 4) {
                const std::size_t left = (before + 1) % 4;
                const std::size_t right = (before + 3) % 4;
                direction = here.test(left) ? left : here.test(before) ? before : right;
            }
            if (!here.test(direction)) {
                break;
            }
            here.reset(direction);
            if (direction != before) {
                ring.push_back(at);
            }
            at = plus(at, kDirections[direction]);
            before = direction;
        }
        ring.push_back(ring.front());
        return ring;
    }

    const std::set<UnitCell>& cells_;
    std::map<UnitCell, std::bitset<4>> sides_;  ///< by the vertex that they start from
    std::map<UnitCell, std::size_t> part_of_;
    std::size_t parts_ = 0;
};

/// One polygon for each set of joined cells, in the order of their first cells. Rings don't cross; they may
/// touch at a vertex.
std::vector<CellPolygon> outlines_of(const std::set<UnitCell>& cells) {
    return Outlines(cells).polygons();
}

double rounded(double value, double digits) {
    return std::floor(value * digits + 0.5) / digits;
}

/// From the campus to the map.
class MapCoordinates {
public:
    explicit MapCoordinates(const scene::Origin& origin) {
        if (origin.geographic) {
            frame_.emplace(*origin.geographic);
        }
    }

    bool is_geographic() const { return frame_.has_value(); }

    Json at(double x, double z) const {
        Json json = at(Vec3(x, 0.0, z));
        json.erase(2);
        return json;
    }

    Json at(const Vec3& p) const {
        if (!frame_) {
            return {rounded(p.x(), 1e5), rounded(-p.z(), 1e5), rounded(p.y(), 1e5)};
        }
        const Vec3 map = frame_->to_map(p);
        return {rounded(map.x(), 1e9), rounded(map.y(), 1e9), rounded(map.z(), 1e5)};
    }

private:
    std::optional<scene::MapFrame> frame_;
};

Json feature(const char* type, Json coordinates, Json properties) {
    return {{"type", "Feature"},
            {"properties", std::move(properties)},
            {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

/// The ground that is reached on a storey.
Json storey_feature(const engine::WalkReport& report, std::size_t storey, const MapCoordinates& map) {
    const engine::WalkSpace& space = report.space;
    std::set<UnitCell> cells;
    engine::NodeNumbers(space).for_each([&](const engine::WalkNodeId& id) {
        if (report.storeys.of(id) == storey && space.node(id).hangs == 0) {
            const engine::GridCell cell = space.cell_of(id);
            cells.emplace(cell.x, -cell.z - 1);
        }
    });
    Json polygons = Json::array();
    for (const CellPolygon& polygon : outlines_of(cells)) {
        Json rings = Json::array();
        for (const Ring& ring : polygon) {
            Json points = Json::array();
            for (const auto& [x, y] : ring) {
                points.push_back(map.at(x * space.grid.cell, -y * space.grid.cell));
            }
            rings.push_back(std::move(points));
        }
        polygons.push_back(std::move(rings));
    }
    const engine::Storey& facts = report.storeys.list[storey];
    return feature("MultiPolygon", std::move(polygons),
                   {{"kind", "reached"},
                    {"storey", storey},
                    {"area", rounded(facts.area, 1e5)},
                    {"main_height", rounded(facts.main_height, 1e5)}});
}

}  // namespace

std::string report_geojson(const scene::Campus& campus, const engine::WalkReport& report,
                           const std::vector<Finding>& findings) {
    const MapCoordinates map(campus.origin);
    Json features = Json::array();
    for (std::size_t i = 0; i < report.storeys.list.size(); ++i) {
        features.push_back(storey_feature(report, i, map));
    }
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        if (subject.kind == engine::SubjectKind::place || subject.kind == engine::SubjectKind::spawn) {
            features.push_back(feature("Point", map.at(subject.at),
                                       {{"kind", engine::name_of(subject.kind)},
                                        {"name", subject.name},
                                        {"reached", subject.reached}}));
        }
    }
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& f = findings[i];
        Json finding =
            feature("Point", f.at ? map.at(*f.at) : Json(),
                    {{"kind", name_of(f.kind)}, {"number", i + 1}, {"subject", f.subject}, {"text", f.text}});
        if (!f.at) {
            finding["geometry"] = nullptr;  // as GeoJSON says of features that are nowhere
        }
        features.push_back(std::move(finding));
    }
    const Json collection = {
        {"type", "FeatureCollection"},
        {"name", campus.description.name},
        {"coordinates", map.is_geographic() ? "longitude, latitude, height" : "metres: x, -z, height"},
        {"features", std::move(features)}};
    return json_text(collection) + "\n";
}

}  // namespace campuswalk::tools::explore
