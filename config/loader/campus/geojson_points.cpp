#include "config/loader/campus/geojson_points.h"

#include <algorithm>
#include <array>
#include <set>

#include "config/loader/json/json_tree.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/ranges.h"
#include "config/loader/yaml/source_text.h"
#include "config/loader/yaml/wording.h"
#include "scene/model/projection.h"

namespace campuswalk::config {

using scene::Diagnostic;
using scene::Severity;
using scene::SourceMark;

namespace {

constexpr Range kLatitudeOfPoint{-scene::kMaxLatitude, scene::kMaxLatitude, false, "degrees"};
constexpr Range kLongitudeOfPoint{-scene::kMaxLongitude, scene::kMaxLongitude, false, "degrees"};
constexpr double kFarthestPlace = 50e3;  // metres from the campus's [0, 0, 0]

constexpr std::array<std::string_view, 6> kOtherGeometries = {
    "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon", "GeometryCollection"};

/// Features that are left out for one reason: their number, and one of them.
struct LeftOut {
    std::size_t count = 0;
    SourceMark first;
    std::string name;

    void add(const SourceMark& mark, const std::string& of) {
        if (++count == 1) {
            first = mark;
            name = of;
        }
    }
};

class PointReader {
public:
    PointReader(const PointFile& file, const CheckedNode& named_at,
                const std::optional<scene::GeographicPlace>& origin, std::vector<Diagnostic>& warnings)
        : file_(file), named_at_(named_at), warnings_(warnings) {
        if (origin) {
            frame_.emplace(*origin);
            at_ = origin->at;
        }
    }

    std::vector<NamedPoint> read(const CheckedNode& root) {
        CheckedMap map(root, "a GeoJSON file");
        const auto type = map.require("type");
        const std::optional<std::string> word = type ? type->text() : std::nullopt;
        if (!map.is_map() || !word || !find_coordinates(map)) {
            return {};
        }
        if (*word == "FeatureCollection") {
            if (const auto features = map.require("features")) {
                for (const CheckedNode& feature : features->items("a feature")) {
                    read_feature(feature);
                }
            }
        } else if (*word == "Feature") {
            read_feature(root);
        } else {
            type->diagnose("bad-value",
                           "'type' must be FeatureCollection or Feature, not " + in_quotes(*word));
            return {};
        }
        report_left_out();
        return std::move(points_);
    }

private:
    /// Whether it is known what the numbers mean.
    bool find_coordinates(CheckedMap& map) {
        const auto stated = map.find("coordinates");
        const std::string said = stated && stated->is_scalar() ? stated->node().text : "";
        const bool says_metres = said.starts_with("metres");
        geographic_ = file_.coordinates ? *file_.coordinates == PlaceCoordinates::geographic : !says_metres;
        if (geographic_ ? says_metres : said.starts_with("longitude")) {
            stated->diagnose("bad-value", "the file says that its coordinates are " + in_quotes(said) +
                                              ", the campus file says something else");
            return false;
        }
        if (!geographic_) {
            return true;
        }
        if (const auto crs = map.find("crs"); crs && !is_wgs84(*crs)) {
            crs->diagnose("bad-crs",
                          "its coordinates are in another system than WGS 84 (longitude, latitude); convert "
                          "the file, for example with `ogr2ogr -t_srs EPSG:4326`");
            return false;
        }
        if (!frame_) {
            named_at_.diagnose(
                "no-origin",
                in_quotes(shown_path(file_.path)) +
                    " has longitudes and latitudes, but the campus doesn't say where it is; add "
                    "origin: {latitude_deg: …, longitude_deg: …}, or 'coordinates: campus' if its "
                    "numbers are metres");
            return false;
        }
        return true;
    }

    /// GeoJSON of 2008 could name another system.
    static bool is_wgs84(const CheckedNode& crs) {
        if (crs.is_null()) {
            return true;
        }
        const auto value_of = [](const YamlNode* map, std::string_view key) {
            for (const YamlNode::Entry& entry : map->entries) {
                if (entry.key == key) {
                    return entry.value.get();
                }
            }
            return static_cast<const YamlNode*>(nullptr);
        };
        const YamlNode* properties = value_of(&crs.node(), "properties");
        const YamlNode* name = properties != nullptr ? value_of(properties, "name") : nullptr;
        return name != nullptr && (name->text.ends_with("CRS84") || name->text.ends_with(":4326"));
    }

    void read_feature(const CheckedNode& node) {
        CheckedMap feature(node, "a feature");
        const auto properties = feature.find("properties");
        const auto geometry = feature.find("geometry");
        if (!feature.is_map()) {
            return;
        }
        if (!properties || properties->is_null()) {
            if (file_.where.empty()) {
                unnamed_.add(node.mark(), "");
            }
            return;
        }
        CheckedMap values(*properties, "'properties'");
        if (!values.is_map()) {
            return;
        }
        for (const CheckedNode::Entry& entry : properties->entries()) {
            seen_.insert(entry.key);
        }
        if (!is_wanted(values)) {
            return;
        }
        const auto name_node = values.find(file_.name_property);
        const bool is_named = name_node && !name_node->is_null();
        const std::optional<std::string> name = is_named ? name_node->text() : "";
        if (!name) {
            return;  // which has been reported
        }
        if (name->empty()) {
            unnamed_.add(node.mark(), "");
            return;
        }
        read_geometry(node.mark(), *name, geometry);
    }

    bool is_wanted(CheckedMap& values) const {
        return std::ranges::all_of(file_.where, [&](const auto& condition) {
            const auto value = values.find(condition.first);
            return value && value->is_scalar() &&
                   std::ranges::find(condition.second, value->node().text) != condition.second.end();
        });
    }

    void read_geometry(const SourceMark& mark, const std::string& name,
                       const std::optional<CheckedNode>& geometry) {
        if (!geometry || geometry->is_null()) {
            not_points_.add(mark, name);
            return;
        }
        CheckedMap map(*geometry, "'geometry'");
        const auto type = map.require("type");
        const std::optional<std::string> word = type ? type->text() : std::nullopt;
        if (!word) {
            return;
        }
        if (std::ranges::find(kOtherGeometries, *word) != kOtherGeometries.end()) {
            not_points_.add(mark, name);
        } else if (*word != "Point") {
            type->diagnose("bad-value", "'type' must be Point, not " + in_quotes(*word));
        } else if (const auto coordinates = map.require("coordinates")) {
            read_point(mark, name, *coordinates);
        }
    }

    void read_point(const SourceMark& mark, const std::string& name, const CheckedNode& coordinates) {
        const std::vector<CheckedNode> items = coordinates.items("a coordinate");
        if (!coordinates.is_sequence()) {
            return;  // which has been reported
        }
        if (items.size() < 2) {
            coordinates.diagnose("bad-value",
                                 geographic_ ? "a point must be [longitude, latitude] or, with a height, "
                                               "[longitude, latitude, height]"
                                             : "a point must be [x, -z] or, with a height, [x, -z, height]");
            return;
        }
        const auto first = items[0].number(geographic_ ? kLongitudeOfPoint : kCoordinate);
        const auto second = items[1].number(geographic_ ? kLatitudeOfPoint : kCoordinate);
        const bool own_height = items.size() > 2;
        const auto third = own_height ? items[2].number(kCoordinate) : std::optional(0.0);
        if (!first || !second || !third) {
            return;
        }
        NamedPoint point{mark, name, {*first, *third, -*second}, own_height || file_.height};
        if (geographic_) {
            point.position = frame_->to_world({*first, *second, *third});
            const Eigen::Vector3d back = frame_->to_map(point.position);  // the far side of the Earth isn't
            const Eigen::Vector3d apart = point.position - at_;
            if (!(std::abs(back.y() - *second) < 1e-3) ||
                apart.x() * apart.x() + apart.z() * apart.z() > kFarthestPlace * kFarthestPlace) {
                far_.add(mark, name);
                return;
            }
        }
        if (!own_height) {
            point.position.y() = file_.height.value_or(0.0);
        }
        points_.push_back(std::move(point));
    }

    void report_left_out() {
        const auto warn = [&](const LeftOut& left, scene::DiagnosticCode code, const std::string& text) {
            if (left.count > 0) {
                const std::string them =
                    left.count == 1
                        ? "the feature " + in_quotes(left.name) + " is"
                        : std::to_string(left.count) + " features, such as " + in_quotes(left.name) + ", are";
                warnings_.push_back({Severity::warning, left.first, code, them + text});
            }
        };
        if (unnamed_.count > 0) {
            warnings_.push_back({Severity::warning, unnamed_.first, "unnamed-feature",
                                 std::to_string(unnamed_.count) +
                                     (unnamed_.count == 1 ? " feature is" : " features are") +
                                     " left out without a property " + in_quotes(file_.name_property) +
                                     "; say which property is the name with 'name', or choose with 'where'"});
        }
        warn(
            not_points_, "not-a-point",
            " left out, as a place is a single point; make points of them, for example with QGIS's 'Point on "
            "surface'");
        warn(far_, "far-place",
             " left out, as they are more than 50 km from the campus's origin; longitude comes before "
             "latitude");
        if (points_.empty() && named_at_.diagnostics().all().empty()) {
            named_at_.diagnose(
                "no-places",
                in_quotes(shown_path(file_.path)) + " has no point with a property " +
                    in_quotes(file_.name_property) +
                    (seen_.contains(file_.name_property)
                         ? " that is wanted and near"
                         : "; its features have " +
                               (seen_.empty() ? "no properties" : listed({seen_.begin(), seen_.end()}))));
        }
    }

    const PointFile& file_;
    const CheckedNode& named_at_;
    std::vector<Diagnostic>& warnings_;
    std::optional<scene::MapFrame> frame_;
    Eigen::Vector3d at_ = Eigen::Vector3d::Zero();
    bool geographic_ = true;
    std::vector<NamedPoint> points_;
    std::set<std::string> seen_;  ///< properties of the features
    LeftOut unnamed_;
    LeftOut not_points_;
    LeftOut far_;
};

}  // namespace

std::vector<NamedPoint> read_points(const PointFile& file, const CheckedNode& named_at,
                                    const ReadRoots& roots,
                                    const std::optional<scene::GeographicPlace>& origin,
                                    std::vector<Diagnostic>& warnings) {
    if (const std::string why = roots.why_unreadable(file.path); !why.empty()) {
        named_at.diagnose("outside-project", in_quotes(shown_path(file.path)) + " " + why);
        return {};
    }
    scene::DiagnosticList& diagnostics = named_at.diagnostics();
    const auto text = read_bytes(file.path, named_at.mark(), diagnostics);
    const std::string shown = shown_path(file.path);
    const bool admitted = text && roots.budget().admit(*text, shown, diagnostics);
    const auto root = admitted ? parse_json(*text, shown, diagnostics) : nullptr;
    if (!root) {
        return {};
    }
    return PointReader(file, named_at, origin, warnings)
        .read(CheckedNode(*root, "the file", shown, diagnostics));
}

}  // namespace campuswalk::config
