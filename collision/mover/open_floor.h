#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "collision/mover/move_context.h"

namespace campuswalk::collision {

/// Where a body stands after a tick on the ground.
struct FloorPlace {
    Vec3 foot = Vec3::Zero();
    double support_y = 0.0;  ///< see MoverState
};

/// Where the mover has only one thing to do: to keep the body on a face. Around some places that a body has
/// walked over, it is known how far nothing else matters: every other piece of the solid world is out of its
/// reach, or lies so much lower or so far aside that the body doesn't touch it. There the body gets as far as
/// it desires, and its height follows from the face alone: bit for bit what the queries would say, for a
/// small part of their time. A world without changes is taken for granted, as by MoverCache.
class OpenFloors {
public:
    /// Where a body gets to that stands at `foot`; none where that isn't known.
    std::optional<FloorPlace> walk(const MoverSettings& body, const Vec3& foot, const Vec3& desired);

    /// Finds out how far around `foot` the floor is open to a body that has come there by a move of `length`
    /// and may go on as fast. `context` is that move's.
    void learn(MoveContext& context, const Vec3& foot, double length);

    void clear();

private:
    /// What carries the body.
    struct Face {
        Vec3 vertex = Vec3::Zero();
        Vec3 up = Vec3::UnitY();  ///< its normal
    };
    /// A place, and a floor round it.
    struct OpenFloor {
        Vec3 center = Vec3::Zero();
        double radius = -1.0;  ///< of the circle, seen from above, that the body's foot is to stay in
        double length = 0.0;   ///< of the longest move
        std::array<Face, 2> faces;
        std::size_t face_count = 0;  ///< 2: one face lies on the other, as in models with back faces
    };
    class Survey;

    const OpenFloor* find(const Vec3& from, const Vec3& to);

    std::vector<OpenFloor> floors_;  ///< a hash table by place, in which newer ones replace older ones
    std::size_t last_ = 0;           ///< where one was found last
    int pause_ = 0;                  ///< moves to go before it is worth trying again
};

}  // namespace campuswalk::collision
