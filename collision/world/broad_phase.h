#pragma once

#include <cstdint>
#include <vector>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// An object of a World, numbered in the order of World::add.
enum class ObjectId : std::uint32_t {};

constexpr std::size_t index_of(ObjectId id) {
    return static_cast<std::size_t>(id);
}

/// Finds the static objects whose boxes overlap a query. Implementations may return candidates in any order
/// (World sorts them, so that the order can't affect results), and too many, never too few.
class BroadPhase {
public:
    virtual ~BroadPhase() = default;

    virtual void insert(ObjectId id, const Aabb& box) = 0;
    /// Appends to `out` every object whose box overlaps `box`.
    virtual void overlapping(const Aabb& box, std::vector<ObjectId>& out) const = 0;
    /// Appends to `out` every object whose box the segment from `from` to `to` intersects.
    virtual void crossing(const Vec3& from, const Vec3& to, std::vector<ObjectId>& out) const = 0;
};

/// Tests every box: the reference for other broad phases, and sufficient for a few objects.
class LinearBroadPhase final : public BroadPhase {
public:
    void insert(ObjectId id, const Aabb& box) override;
    void overlapping(const Aabb& box, std::vector<ObjectId>& out) const override;
    void crossing(const Vec3& from, const Vec3& to, std::vector<ObjectId>& out) const override;

private:
    struct Entry {
        ObjectId id{};
        Aabb box;
    };
    std::vector<Entry> entries_;
};

}  // namespace campuswalk::collision
