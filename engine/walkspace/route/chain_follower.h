#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "engine/walkspace/route/guessed_path.h"
#include "engine/walkspace/route/route_draft.h"
#include "engine/walkspace/stride/stride.h"

namespace campuswalk::engine {

/// A node of a chain that a route follows.
struct ChainNode {
    Stride stride;  ///< to it
    GroundState at;
    Tick ticks = 0;  ///< from the chain's start
    Tick tight = 0;  ///< of them, of strides that end in tight places
};

/// Follows a chain of nodes towards a goal by straight pieces that lead over as many of them as can be.
class ChainFollower {
public:
    /// `goal`: the piece that ends there. `draft` and `map` must outlive it.
    ChainFollower(RouteDraft& draft, GroundMap& map, const RoutePiece& goal)
        : draft_(draft), map_(map), goal_(goal) {}

    /// Follows a way over the map. Returns the node from which no piece leads on; the chain's size at the
    /// goal.
    std::size_t follow_guess(std::vector<ChainNode> chain, const GuessRules& rules);
    /// Follows strides of the walk space, one by one if there are to be no `pieces`. Returns whether the goal
    /// is reached. If not, the body stands where no node of the chain can be walked to from, and has come
    /// nearer.
    bool follow_strides(std::vector<ChainNode> chain, const WalkGrid& grid, bool pieces);

    /// Most ticks of the last piece: it may go round what stands beside the goal.
    Tick last_ticks() const;
    /// Whether nodes there are asked whether they lead to the goal.
    bool is_near_goal(const collision::Vec3& foot) const;
    /// A straight way may overlap things that the body slides along by so much, metres.
    double slide_allowed() const;

private:
    /// Where on the chain a piece leads.
    struct Pull {
        std::size_t node = 0;
        WalkedPiece walked;
    };

    std::optional<Pull> farthest(std::size_t at, const std::function<bool(std::size_t)>& may_lead);
    std::optional<Pull> piece_to(std::size_t at, std::size_t node);
    double falls_of_chain(std::size_t from, std::size_t to) const;
    Tick tight_ticks_at_goal(std::vector<collision::Vec3> path) const;
    void take_stride(const Stride& stride, const WalkGrid& grid);

    RouteDraft& draft_;
    GroundMap& map_;
    const RoutePiece goal_;
    std::vector<ChainNode> chain_;
};

}  // namespace campuswalk::engine
