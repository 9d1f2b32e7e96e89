#pragma once

#include <vector>

#include "collision/ball_rest.h"
#include "collision/mover_settings.h"
#include "collision/neighbourhood.h"

namespace campuswalk::collision {

/// What a body that comes straight down would stand on.
struct Ground {
    bool found = false;    ///< something is there
    bool carries = false;  ///< and can be stood on
    double foot_y = 0.0;   ///< where the foot comes to rest, kRest above it
};

/// Tells ground from walls, by the faces of what the body would touch, not by where it touches them: edges
/// as high as a step allows carry if a walkable face ends there, and no edge is climbed that is higher, how
/// ever round the body is.
class Footing {
public:
    explicit Footing(const MoverSettings& settings) : settings_(settings) {}

    /// How far sideways of the body `kind` looks, metres: what is near must have been surveyed for it.
    static constexpr double kProbe = 0.06;

    /// Looks among what is near for the highest ground at (x, z) within `up` above and `down` below
    /// `stand.y()`, where the body stands now: heights of edges count from there.
    Ground ground(const Neighbourhood& around, double x, double z, const Vec3& stand, double up, double down);

    Kind kind(Neighbourhood& around, Neighbourhood::Index i, const Vec3& foot);

private:
    struct Rest {
        Neighbourhood::Index piece = 0;
        BallRest ball;
    };

    std::optional<BallRest> rest_on(const Neighbourhood::Piece& piece, double x, double z, double highest,
                                    double lowest) const;
    bool carries(const Neighbourhood& around, const Rest& rest, double highest_edge) const;
    Kind kind_of(const Neighbourhood& around, const Obstacle& obstacle, const Separation& separation,
                 double highest_edge);
    bool ends_in_floor(const Neighbourhood& around, const Vec3& point) const;
    bool reaches_over(const Obstacle& obstacle, const Vec3& foot, double height) const;

    MoverSettings settings_;
    std::vector<Rest> rests_;
};

}  // namespace campuswalk::collision
