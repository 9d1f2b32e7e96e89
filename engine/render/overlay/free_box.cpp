#include "engine/render/overlay/free_box.h"

#include <algorithm>

namespace campuswalk::engine::render {
namespace {

// Boxes that only touch don't.
bool overlap(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b) {
    return (a.min().array() < b.max().array()).all() && (b.min().array() < a.max().array()).all();
}

}  // namespace

std::optional<Eigen::AlignedBox2d> free_box(const Eigen::AlignedBox2d& area, const Eigen::Vector2d& at,
                                            const Eigen::Vector2d& half,
                                            std::span<const Eigen::Vector2d> shifts,
                                            std::span<const Eigen::AlignedBox2d> taken) {
    for (const Eigen::Vector2d& shift : shifts) {
        const Eigen::Vector2d middle = at + half.cwiseProduct(shift);
        const Eigen::AlignedBox2d box(middle - half, middle + half);
        const bool inside =
            (box.min().array() > area.min().array()).all() && (box.max().array() < area.max().array()).all();
        if (inside && std::ranges::none_of(taken, [&](const auto& other) { return overlap(box, other); })) {
            return box;
        }
    }
    return std::nullopt;
}

}  // namespace campuswalk::engine::render
