#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/world/broad_phase.h"

namespace campuswalk::collision {

/// The paper's three detection modes that an object takes part in; values combine as bits.
enum class Detection : std::uint8_t { none = 0, solid = 1, trigger = 2, ray = 4 };

constexpr Detection operator|(Detection a, Detection b) {
    return static_cast<Detection>(static_cast<std::uint8_t>(a) | static_cast<std::uint8_t>(b));
}
constexpr bool any_of(Detection set, Detection others) {
    return (static_cast<std::uint8_t>(set) & static_cast<std::uint8_t>(others)) != 0;
}

/// A static object of the world.
struct Object {
    Shape shape;
    Pose X_world_shape;
    Detection detection = Detection::solid;
    std::uint32_t layer = 0;  ///< 0..31
};

/// Which objects a query considers.
struct QueryFilter {
    Detection detection = Detection::solid;
    std::uint32_t ignored_layers = 0;             ///< bit n set: layer n is ignored
    const std::vector<bool>* disabled = nullptr;  ///< by object: ignored; null if none is

    friend bool operator==(const QueryFilter&, const QueryFilter&) = default;
};

/// The static world: objects in a broad phase, the trees of their meshes as the narrow phase. Immutable once
/// filled; queries are const and return objects by ascending id, whatever the broad phase's order.
class World {
public:
    explicit World(std::unique_ptr<BroadPhase> broad_phase);

    ObjectId add(Object object);

    std::size_t size() const { return objects_.size(); }
    const Object& object(ObjectId id) const { return objects_[index_of(id)]; }
    const Aabb& bounds(ObjectId id) const { return bounds_[index_of(id)]; }
    /// Of all objects together.
    const Aabb& bounds() const { return total_bounds_; }

    /// Replaces `out` by the objects that pass the filter and whose boxes overlap `box`, ascending.
    void candidates(const Aabb& box, const QueryFilter& filter, std::vector<ObjectId>& out) const;
    /// Likewise for the segment from `from` to `to`.
    void candidates(const Vec3& from, const Vec3& to, const QueryFilter& filter,
                    std::vector<ObjectId>& out) const;

private:
    void apply_filter(const QueryFilter& filter, std::vector<ObjectId>& out) const;

    std::unique_ptr<BroadPhase> broad_phase_;
    std::vector<Object> objects_;
    std::vector<Aabb> bounds_;
    Aabb total_bounds_;
};

}  // namespace campuswalk::collision
