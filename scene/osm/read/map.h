#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene::osm {

/// What an OpenStreetMap file says, in metres: plain data, no geometry made from it yet.
///
/// Points of the plan are (east, north) about the map's centre; the world frame has x = east, y = up,
/// z = -north. A ring counter-clockwise in the plan is so seen from above.
using Point = Eigen::Vector2d;

/// Keys and values of an element, ordered by key.
class Tags {
public:
    Tags() = default;
    explicit Tags(std::vector<std::pair<std::string, std::string>> pairs);

    /// The value; empty if the key is missing.
    std::string_view get(std::string_view key) const;
    bool has(std::string_view key) const { return !get(key).empty(); }
    bool is(std::string_view key, std::string_view value) const { return get(key) == value; }
    bool empty() const { return pairs_.empty(); }
    /// These, and of `others` those whose keys are missing here.
    Tags with(const Tags& others) const;
    const std::vector<std::pair<std::string, std::string>>& all() const { return pairs_; }

private:
    std::vector<std::pair<std::string, std::string>> pairs_;
};

/// The kinds of elements that OpenStreetMap has.
enum class ElementKind : std::uint8_t { node, way, relation };

/// What identifies an element, such as way 123.
struct ElementId {
    ElementKind kind = ElementKind::node;
    std::int64_t number = 0;

    /// "way-123"; of a negative number, as editors give to what is new, "way-n123".
    std::string text() const;
    friend bool operator==(const ElementId&, const ElementId&) = default;
};

/// A node with tags.
struct MapNode {
    std::int64_t id = 0;
    Point at = Point::Zero();
    Tags tags;
};

struct MapWay {
    std::int64_t id = 0;
    std::vector<std::int64_t> nodes;  ///< those that the file has
    std::vector<Point> points;        ///< one per node
    bool complete = true;             ///< the file has all its nodes
    Tags tags;

    bool closed() const { return nodes.size() > 3 && nodes.front() == nodes.back(); }
};

struct Member {
    ElementId element;
    std::string role;
};

struct MapRelation {
    std::int64_t id = 0;
    std::vector<Member> members;
    Tags tags;
};

/// An axis-aligned rectangle of the plan, metres.
struct Box {
    Point min = Point::Zero();
    Point max = Point::Zero();

    bool contains(const Point& p) const {
        return p.x() >= min.x() && p.y() >= min.y() && p.x() <= max.x() && p.y() <= max.y();
    }
    bool overlaps(const Box& other) const {
        return min.x() <= other.max.x() && other.min.x() <= max.x() && min.y() <= other.max.y() &&
               other.min.y() <= max.y();
    }
    Box grown(double by) const { return {min - Point(by, by), max + Point(by, by)}; }
    Point size() const { return max - min; }
    void extend(const Point& p) {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
};

/// The smallest box of some points; at least one.
Box box_of(const std::vector<Point>& points);

/// Degrees, WGS 84. Across the antimeridian `east` is above 180.
struct GeographicBox {
    double south = 0.0;
    double west = 0.0;
    double north = 0.0;
    double east = 0.0;

    bool contains(double latitude, double longitude) const {
        const double on_turn = longitude_near(longitude);
        return latitude >= south && latitude <= north && on_turn >= west && on_turn <= east;
    }
    /// The same meridian, within half a turn of the box's middle.
    double longitude_near(double longitude) const {
        const double middle = 0.5 * (west + east);
        return longitude < middle - 180.0   ? longitude + 360.0
               : longitude > middle + 180.0 ? longitude - 360.0
                                            : longitude;
    }
};

/// The shorter way around the Earth between two meridians: what is more than half a turn wide crosses the
/// antimeridian.
inline GeographicBox shorter_way(const GeographicBox& box) {
    return box.east - box.west > 180.0 ? GeographicBox{box.south, box.east, box.north, box.west + 360.0}
                                       : box;
}

struct Map {
    GeographicBox geographic;
    Box box;                                                  ///< the same, about its centre
    std::size_t nodes_read = 0;                               ///< with tags or not
    std::vector<MapNode> nodes;                               ///< those with tags, by id
    std::vector<MapWay> ways;                                 ///< by id
    std::vector<MapRelation> relations;                       ///< by id
    std::unordered_map<std::int64_t, std::size_t> way_index;  ///< into `ways`, by id

    const MapWay* way(std::int64_t id) const {
        const auto found = way_index.find(id);
        return found == way_index.end() ? nullptr : &ways[found->second];
    }
};

}  // namespace campuswalk::scene::osm
