#include "tools/campuswalk/explore/geojson.h"

#include <cmath>
#include <numbers>
#include <set>

#include "engine/walkspace/node_numbers.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/explore/cell_outlines.h"

namespace campuswalk::tools::explore {

using collision::Vec3;

namespace {

double rounded(double value, double digits) {
    return std::floor(value * digits + 0.5) / digits;
}

/// From the campus to the map. On an area of a few kilometres the ellipsoid's own radii at the origin are
/// exact to centimetres.
class MapCoordinates {
public:
    explicit MapCoordinates(const scene::Origin& origin) : place_(origin.geographic) {
        if (place_) {
            constexpr double kEquator = 6378137.0;  // WGS 84
            constexpr double kFlattening = 1.0 / 298.257223563;
            const double e2 = kFlattening * (2.0 - kFlattening);
            const double latitude = place_->latitude_deg * kRadians;
            const double w = 1.0 - e2 * std::sin(latitude) * std::sin(latitude);
            meridian_ = kEquator * (1.0 - e2) / (w * std::sqrt(w));
            parallel_ = kEquator / std::sqrt(w) * std::cos(latitude);
        }
    }

    bool is_geographic() const { return place_.has_value(); }

    Json at(double x, double z) const {
        if (!place_) {
            return {rounded(x, 1e5), rounded(-z, 1e5)};
        }
        const double east = x - place_->at.x();
        const double north = place_->at.z() - z;
        return {rounded(place_->longitude_deg + east / parallel_ / kRadians, 1e9),
                rounded(place_->latitude_deg + north / meridian_ / kRadians, 1e9)};
    }

    Json at(const Vec3& p) const {
        Json json = at(p.x(), p.z());
        json.push_back(rounded(place_ ? p.y() - place_->at.y() + place_->height : p.y(), 1e5));
        return json;
    }

private:
    static constexpr double kRadians = std::numbers::pi / 180.0;

    std::optional<scene::GeographicPlace> place_;
    double meridian_ = 0.0;  ///< metres per radian to the north
    double parallel_ = 0.0;  ///< and to the east
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
        features.push_back(feature("Point", map.at(findings[i].at),
                                   {{"kind", name_of(findings[i].kind)},
                                    {"number", i + 1},
                                    {"subject", findings[i].subject},
                                    {"text", findings[i].text}}));
    }
    const Json collection = {
        {"type", "FeatureCollection"},
        {"name", campus.description.name},
        {"coordinates", map.is_geographic() ? "longitude, latitude, height" : "metres: x, -z, height"},
        {"features", std::move(features)}};
    return json_text(collection) + "\n";
}

}  // namespace campuswalk::tools::explore
