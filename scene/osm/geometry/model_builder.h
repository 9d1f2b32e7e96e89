#pragma once

#include <cstddef>
#include <deque>
#include <exception>
#include <map>
#include <string>
#include <utility>

#include "scene/model/model.h"
#include "scene/osm/geometry/plan_geometry.h"
#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {

/// What a surface looks like.
struct Look {
    Color color = {200, 200, 200};
    std::uint8_t roughness = 230;  ///< of 255
    std::uint8_t alpha = 255;

    friend auto operator<=>(const Look&, const Look&) = default;
};

/// A point of the plan at a height, metres: the world's (x, y, z) is (east, height, -north).
struct Point3 {
    Point at = Point::Zero();
    double height = 0.0;
};

/// A campus that can be walked on in a day has fewer. Reached long before memory or time end on any machine.
inline constexpr std::size_t kMaxMapTriangles = 10'000'000;

/// Thrown when a map makes more triangles than that.
class TooManyTriangles : public std::exception {};

/// The triangles of one node, by look. Every face is flat: normals are those of its triangles.
class ObjectMesh {
public:
    /// `made` counts the triangles of the whole model.
    explicit ObjectMesh(std::size_t& made) : made_(&made) {}

    /// Counter-clockwise seen from where it is visible.
    void triangle(const Look& look, const Point3& a, const Point3& b, const Point3& c);
    void quad(const Look& look, const Point3& a, const Point3& b, const Point3& c, const Point3& d);
    /// Level triangles, seen from above.
    void level(const Look& look, const Triangulation& area, double height);
    /// The same from below.
    void ceiling(const Look& look, const Triangulation& area, double height);
    /// An upright wall from a to b, seen from the right of that direction.
    void wall(const Look& look, const Point& a, const Point& b, double bottom, double top);
    /// The walls around polygons, seen from outside.
    void walls(const Look& look, const Polygons& polygons, double bottom, double top);
    /// An upright box: `along` is the unit direction of its length.
    void box(const Look& look, const Point& center, const Point& along, const Point& half_size, double bottom,
             double top);
    /// An upright regular prism, or a pyramid if `top_radius` is 0.
    void cylinder(const Look& look, const Point& center, double bottom_radius, double top_radius, int sides,
                  double bottom, double top);

private:
    friend class ModelBuilder;
    using Vertices = std::array<Eigen::Vector3f, 3>;
    std::size_t* made_;
    /// Deques, as vectors that grow would strew the memory with gaps, from which the many small objects of
    /// GEOS are then taken: the time of an import would grow faster than its map.
    std::map<Look, std::deque<Vertices>> parts_;
};

/// Collects named meshes into a model: one node an object. Adding to them throws TooManyTriangles.
class ModelBuilder {
public:
    ModelBuilder() = default;
    ModelBuilder(const ModelBuilder&) = delete;
    ModelBuilder& operator=(const ModelBuilder&) = delete;

    /// The mesh of that name, which is added if it is new. References stay valid.
    ObjectMesh& object(const std::string& name);
    /// The object with the most triangles and how many these are; empty for none.
    std::pair<std::string, std::size_t> largest() const;
    /// The model; meshes are in the order in which objects were added. Objects without triangles are left
    /// out.
    Model finish();

private:
    MaterialIndex material(const Look& look, Model& model);

    std::size_t triangles_ = 0;
    std::deque<std::pair<std::string, ObjectMesh>> objects_;
    std::map<std::string, std::size_t> known_;
    std::map<Look, MaterialIndex> materials_;
};

}  // namespace campuswalk::scene::osm
