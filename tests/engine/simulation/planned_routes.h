#pragma once

#include <cstddef>
#include <optional>

#include <gtest/gtest.h>

#include "engine/script/route_planner.h"

namespace campuswalk::engine {

/// It took walking everywhere.
inline PlannedRoute searched_route() {
    PlannedRoute planned;
    planned.route.pieces = {{{"", {1.0 / 3.0, 0, 2}, false}, 0.05, std::nullopt, 17},
                            {{"desk", {4, 0.2, -12}, true}, 0.25, Eigen::Vector3d(0.02, 0, 1e-9), 600}};
    planned.route.path = {{0, 0, 12}, {1.0 / 3.0, 0, 2}, {4, 0.2, -12}};
    planned.route.searched = true;
    return planned;
}

inline void expect_same(const PlannedRoute& a, const PlannedRoute& b) {
    EXPECT_EQ(a.why_not, b.why_not);
    ASSERT_EQ(a.route.pieces.size(), b.route.pieces.size());
    for (std::size_t i = 0; i < a.route.pieces.size(); ++i) {
        const RoutePiece& piece = a.route.pieces[i];
        const RoutePiece& other = b.route.pieces[i];
        EXPECT_EQ(piece.target.label, other.target.label);
        EXPECT_EQ(piece.target.point, other.target.point);
        EXPECT_EQ(piece.target.has_height, other.target.has_height);
        EXPECT_EQ(piece.within, other.within);
        EXPECT_EQ(piece.stride, other.stride);
        EXPECT_EQ(piece.ticks, other.ticks);
    }
}

/// With each member of a reason, in it or in its parts.
inline PlannedRoute no_route() {
    const Reason riser{.kind = ReasonKind::riser,
                       .object = "stair",
                       .node = "step-1",
                       .is_node = true,
                       .at = Eigen::Vector3d(3.2, 0.45, -1.0),
                       .measured = 0.45,
                       .allowed = 0.3,
                       .look_at = Eigen::Vector3d(3.2, 0.9, -1.0)};
    Reason enclosed{.kind = ReasonKind::enclosed, .object = "gate", .measured = 2.0, .parts = {riser}};
    enclosed.detour = 7.5;
    enclosed.from = Eigen::Vector3d(1, 2, 3);
    enclosed.room = Eigen::Vector3d(4, 5, 1.0 / 3.0);
    return {{}, Reason{.kind = ReasonKind::through, .name = "hall", .more = 3, .parts = {enclosed}}};
}

}  // namespace campuswalk::engine
