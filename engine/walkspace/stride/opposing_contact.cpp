#include "engine/walkspace/stride/opposing_contact.h"

#include <vector>

#include "collision/world/obstacle.h"

namespace campuswalk::engine {

using collision::Obstacle;
using collision::Vec3;

std::optional<OpposingContact> opposing_contact(const collision::World& world,
                                                const collision::QueryFilter& solids,
                                                const collision::MoverSettings& body, const Vec3& foot,
                                                const Vec3& ahead) {
    constexpr double kReach = 0.05;
    constexpr double kLeast = 0.1;  // of the cosine between the contact and the move
    const collision::Segment core = body.core(foot);
    std::vector<Obstacle> near;
    collision::gather_obstacles(world, solids, core, body.radius + body.skin + kReach, near);
    std::optional<OpposingContact> contact;
    double strongest = kLeast;
    for (const Obstacle& piece : near) {
        const collision::Closest c = collision::closest(core, piece);
        const Vec3 towards = c.on_shape - c.on_segment;  // down to the ground, which is in no one's way
        const double lengths = towards.norm() * ahead.norm();
        const double against = lengths > 0.0 ? towards.dot(ahead) / lengths : 0.0;
        if (against > strongest) {
            strongest = against;
            contact = OpposingContact{piece.object, piece.triangle, c.on_shape};
        }
    }
    return contact;
}

}  // namespace campuswalk::engine
