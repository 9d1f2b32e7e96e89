#include "collision/mover/ground_candidates.h"

#include <array>
#include <bit>
#include <cmath>

namespace campuswalk::collision {

namespace {

/// As std::max but for rounding, in a form that compilers turn into instructions for several lanes at once.
float larger(float a, float b) {
    return 0.5F * (a + b + std::abs(a - b));
}

/// 1 if either is negative, else 0.
std::uint32_t either_negative(float a, float b) {
    return (std::bit_cast<std::uint32_t>(a) | std::bit_cast<std::uint32_t>(b)) >> 31U;
}

}  // namespace

void list_candidates(MoveContext& context, const Support& stand, double up, double down) {
    GroundCandidates& ground = context.buffers.ground;
    const double reach = context.body.radius + 2.0 * kRestGap;
    const double aside = reach + kProbeDistance;
    const double center = context.body.radius;
    // What a sphere rests on is below its centre.
    const Aabb region{{-aside, center - down - 2.0 * kRestGap - reach, -aside}, {aside, center + up, aside}};
    ground.pieces.clear();
    ground.boxes.clear();
    ground.pieces.reserve(context.contacts.capacity());
    ground.boxes.reserve(context.contacts.capacity() / GroundCandidates::kLanes + 1);
    for (const ContactCache::Index i : context.near) {
        const Aabb& box = context.contacts.piece(i).box;
        const Aabb about{box.min - stand.foot, box.max - stand.foot};
        if (!about.overlaps(region)) {
            continue;
        }
        const std::size_t lane = ground.pieces.size() % GroundCandidates::kLanes;
        if (lane == 0) {
            ground.boxes.emplace_back();
        }
        const Vec3 low = about.min.cwiseMax(region.min);
        const Vec3 high = about.max.cwiseMin(region.max);
        GroundCandidates::Boxes& b = ground.boxes.back();
        b.min_x[lane] = static_cast<float>(low.x());
        b.max_x[lane] = static_cast<float>(high.x());
        b.min_z[lane] = static_cast<float>(low.z());
        b.max_z[lane] = static_cast<float>(high.z());
        b.low[lane] = static_cast<float>(low.y());
        b.top[lane] = static_cast<float>(high.y());
        ground.pieces.push_back(i);
    }
    ground.chosen.reserve(context.contacts.capacity() + GroundCandidates::kLanes + 1);
    ground.chosen.resize(ground.boxes.size() * GroundCandidates::kLanes + 1);
    ground.foot = stand.foot;
    ground.base = stand.base;
}

std::span<const std::uint32_t> choose_candidates(GroundCandidates& ground, double reach,
                                                 const Descent& descent) {
    const auto [x, z, useful, highest] = descent;
    // Far more than float32's of the numbers that are squared below.
    const double scale = reach + kProbeDistance + std::abs(static_cast<double>(highest));
    const double rounding = 1e-5 * scale * scale;
    const auto most2 = static_cast<float>(reach * reach + rounding);
    const auto least2 = static_cast<float>(reach * reach - rounding);
    std::size_t count = 0;
    std::size_t first = 0;
    for (const GroundCandidates::Boxes& b : ground.boxes) {
        std::array<std::uint32_t, GroundCandidates::kLanes> out;
        std::uint32_t all_out = 1;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const float near_x = larger(larger(b.min_x[i] - x, x - b.max_x[i]), 0.0F);
            const float near_z = larger(larger(b.min_z[i] - z, z - b.max_z[i]), 0.0F);
            const float far_x = larger(x - b.min_x[i], b.max_x[i] - x);
            const float far_z = larger(z - b.min_z[i], b.max_z[i] - z);
            const float above = larger(useful - b.top[i], 0.0F);
            const float below = highest - b.low[i];
            const float in_reach = most2 - (near_x * near_x + near_z * near_z + above * above);
            const float out_of_reach = far_x * far_x + far_z * far_z + below * below - least2;
            out[i] = either_negative(in_reach, out_of_reach);
        }
        for (const std::uint32_t lane : out) {
            all_out &= lane;
        }
        if (all_out == 0) {
            for (std::size_t i = 0; i < out.size(); ++i) {
                ground.chosen[count] = static_cast<std::uint32_t>(first + i);
                count += 1U - out[i];
            }
        }
        first += GroundCandidates::kLanes;
    }
    return {ground.chosen.data(), count};
}

}  // namespace campuswalk::collision
