#pragma once

#include <vector>

#include "collision/mover/ball_rest.h"
#include "collision/mover/contact_cache.h"
#include "collision/mover/mover_settings.h"

namespace campuswalk::collision {

/// Where the body stands, and the height that edges count from.
struct Support {
    Vec3 foot = Vec3::Zero();
    double base = 0.0;  ///< of what carries it; not below the foot
};

/// What a body that comes straight down would stand on.
struct Ground {
    bool found = false;    ///< something is there
    bool carries = false;  ///< and can be stood on
    double foot_y = 0.0;   ///< where the foot comes to rest, kRest above it
    double at = 0.0;       ///< height of the highest point that carries
};

/// Tells ground from walls, by the faces of what the body would touch, not by where it touches them: edges
/// as high as a step allows carry if a walkable face ends there, and no edge is climbed that is higher, how
/// ever round the body is.
class GroundQuery {
public:
    explicit GroundQuery(const MoverSettings& settings) : settings_(settings) {}

    /// The body has another height from now on.
    void resize(double height) { settings_.height = height; }

    /// How far sideways of the body `kind` looks, metres: what is near must have been surveyed for it.
    static constexpr double kProbe = 0.06;

    /// Looks among what is near for the highest ground at (x, z) up to `up` above and `down` below where the
    /// body stands now.
    Ground ground(const ContactCache& around, double x, double z, const Support& stand, double up,
                  double down);

    Kind kind(ContactCache& around, ContactCache::Index i, const Support& stand);

private:
    struct Rest {
        ContactCache::Index piece = 0;
        SphereRest ball;
    };

    std::optional<SphereRest> rest_on(const ContactCache::Piece& piece, double x, double z, double highest,
                                      double lowest) const;
    bool carries(const ContactCache& around, const Rest& rest, double highest) const;
    double highest_edge(const Support& stand) const {
        return stand.base + settings_.step_height + kHeightSlack;
    }
    Kind kind_of(const ContactCache& around, const ContactCache::Piece& piece, const Separation& separation,
                 const Support& stand);
    bool ends_in_floor(const ContactCache& around, const Vec3& point) const;
    bool reaches_over(const Obstacle& obstacle, const Vec3& foot, double height) const;

    MoverSettings settings_;
    std::vector<Rest> rests_;
};

}  // namespace campuswalk::collision
