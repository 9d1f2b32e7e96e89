#pragma once

#include <cstddef>
#include <optional>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/explore/explored_campus.h"

namespace campuswalk::tools::bench {

/// Microseconds of all queries, each of which follows an untimed one.
struct QueryTimes {
    double median = 0.0;
    double p99 = 0.0;
};

/// Our routes between random pairs of reached places, beside Detour's over Recast's navigation mesh.
struct RouteScore {
    std::size_t pairs = 0;
    std::size_t joined = 0;      ///< pairs between which walked strides lead
    std::size_t found = 0;       ///< routes, of these pairs
    std::size_t found_else = 0;  ///< routes, of the other pairs
    std::size_t blocked = 0;     ///< routes that a body walks otherwise than planned
    std::size_t by_peer = 0;     ///< paths of the peer that arrive within half a metre, of all pairs
    std::size_t both = 0;        ///< pairs that both arrive in
    /// Geometric mean of ours over the peer's, of pairs that both arrive in; seen from above.
    std::optional<double> length_ratio;
    QueryTimes ours;  ///< on ground that is known, but routes that aren't
    /// Of the same routes again once all are planned: walks often start and go where earlier ones did.
    QueryTimes again;
    std::size_t changed = 0;  ///< of these routes, how many weren't what was planned
    QueryTimes walked;        ///< that a body takes to follow our routes: the mover's share of planning one
    std::optional<QueryTimes> peer;
};

/// Prints what it measures. `space` is what the campus' settings reach. Without a peer (null), ours alone.
RouteScore route_pairs(const ExploredCampus& campus, const engine::WalkSpace& space, NavMeshEngine* peer,
                       std::size_t pairs);

}  // namespace campuswalk::tools::bench
