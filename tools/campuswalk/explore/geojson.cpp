#include "tools/campuswalk/explore/geojson.h"

#include <cmath>
#include <optional>
#include <set>

#include "engine/walkspace/space/node_numbers.h"
#include "scene/model/projection.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/explore/cell_outlines.h"

namespace campuswalk::tools::explore {

using collision::Vec3;

namespace {

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
