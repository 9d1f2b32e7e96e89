#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"
#include "scene/base/diagnostic.h"
#include "scene/model/origin.h"

namespace campuswalk::config {

/// What the numbers of a GeoJSON file are.
enum class PlaceCoordinates {
    campus,      ///< metres: x, -z, height, as on a plan with +X to the right and -Z up
    geographic,  ///< longitude, latitude, height (RFC 7946)
};

/// Which points of a GeoJSON file are wanted, and how to read them.
struct PointFile {
    std::filesystem::path path;
    std::string name_property = "name";
    std::optional<PlaceCoordinates> coordinates;  ///< none: as the file says, else geographic
    std::optional<double> height;                 ///< in the campus, of points without one
    /// Only features that have, of each of these properties, one of the values.
    std::vector<std::pair<std::string, std::vector<std::string>>> where;
};

/// A feature with a name.
struct NamedPoint {
    scene::SourceMark mark;
    std::string name;  ///< as written
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    bool has_height = true;
};

/// The named points of a GeoJSON file, in its order. `named_at` is where the campus file names it, `origin`
/// what that says about the Earth. Features without the name property, or with an empty one, are passed over.
/// Reports errors in the file, all with their places in it:
///   json-syntax, duplicate-key, too-large   see parse_json; missing-file as read_bytes
///   wrong-type, bad-value, missing-key      what isn't GeoJSON; coordinates out of range
///   bad-crs                                 a coordinate system other than WGS 84
///   no-origin, outside-project, no-places   at `named_at`
/// and adds to `warnings`
///   not-a-point                             named features without a single point, which are left out
///   far-place                               points more than 50 km away, which are left out
std::vector<NamedPoint> read_points(const PointFile& file, const CheckedNode& named_at,
                                    const ReadRoots& roots,
                                    const std::optional<scene::GeographicPlace>& origin,
                                    std::vector<scene::Diagnostic>& warnings);

}  // namespace campuswalk::config
