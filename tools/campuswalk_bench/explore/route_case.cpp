#include "tools/campuswalk_bench/explore/route_case.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <variant>

#include "collision/mover/mover.h"
#include "engine/script/travel.h"
#include "engine/simulation/cached_route.h"
#include "engine/walkspace/route/route.h"
#include "tools/campuswalk_bench/measure/measurement.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"
#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

using collision::Vec3;
using engine::GroundState;
using engine::Route;
using engine::WalkNodeId;
using engine::WalkSpace;

namespace {

constexpr std::uint64_t kSeed = 22;
constexpr std::size_t kFailuresShown = 10;
/// A path that ends this near its target arrives, metres along the ground and up.
constexpr double kArrived = 0.5;
constexpr double kArrivedLevel = 1.0;
/// Shorter ways say nothing about lengths, metres.
constexpr double kShortest = 2.0;

struct Pair {
    GroundState from;
    GroundState to;
    bool is_joined = false;
};

/// Whether one can walk back from the node to the start of its chain, from which all others are reached.
bool returns_to_start(const WalkSpace& space, WalkNodeId node) {
    while (const auto parent = space.parent(node)) {
        if (space.node(node).returns == 0) {
            return false;
        }
        node = *parent;
    }
    return true;
}

std::vector<Pair> random_pairs(const ExploredCampus& campus, const WalkSpace& space, std::size_t count) {
    std::vector<WalkNodeId> nodes = nodes_of(space);
    std::erase_if(nodes, [&](const WalkNodeId& node) { return space.node(node).hangs != 0; });
    const engine::ExploreSettings settings = campus.settings();
    engine::Strider strider(campus.world(), settings.strides, settings.solids);
    SplitMix random(kSeed);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < count && !nodes.empty(); ++i) {
        const WalkNodeId from = nodes[random.below(nodes.size())];
        const WalkNodeId to = nodes[random.below(nodes.size())];
        pairs.push_back({space.state_at(from, strider), space.state_at(to, strider),
                         from == to || returns_to_start(space, from)});
    }
    return pairs;
}

/// Whether a body that follows the pieces by the law of the steps goes exactly where they say.
bool is_walked_as_planned(const Route& route, const GroundState& from, const ExploredCampus& campus) {
    const engine::ExploreSettings settings = campus.settings();
    const double length = settings.strides.walk_speed * settings.strides.seconds;
    const collision::CapsuleMover mover(campus.world(), settings.strides.body, settings.solids);
    collision::MoverState state = engine::state_of(from);
    collision::MoverCache cache;
    collision::MoveTrace trace;
    std::size_t tick = 0;
    for (const engine::RoutePiece& piece : route.pieces) {
        for (engine::Tick i = 0; i < piece.ticks; ++i) {
            const Vec3 desired = piece.stride
                                     ? *piece.stride
                                     : engine::displacement_towards(piece.target.point, state.foot, length);
            mover.move(state, desired, settings.strides.seconds, cache, trace);
            if (++tick >= route.path.size() || route.path[tick] != state.foot) {
                return false;
            }
        }
        if (!piece.stride && !engine::has_arrived(piece.target, piece.within, state.foot, state.grounded)) {
            return false;
        }
    }
    return tick + 1 == route.path.size();
}

bool is_same_piece(const engine::RoutePiece& a, const engine::RoutePiece& b) {
    return a.target.point == b.target.point && a.within == b.within && a.stride == b.stride &&
           a.ticks == b.ticks;
}

double length_from_above(const std::vector<Vec3>& path) {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        length += engine::flat(path[i] - path[i - 1]).norm();
    }
    return length;
}

bool ends_at(const std::vector<Vec3>& path, const Vec3& from, const Vec3& to) {
    const auto near = [](const Vec3& a, const Vec3& b) {
        return engine::flat(a - b).norm() <= kArrived && std::abs(a.y() - b.y()) <= kArrivedLevel;
    };
    return near(path.front(), from) && near(path.back(), to);
}

QueryTimes times_of(std::vector<double> microseconds) {
    std::ranges::sort(microseconds);
    const auto at = [&](double share) {
        const auto i = static_cast<std::size_t>(share * static_cast<double>(microseconds.size()));
        return microseconds[std::min(i, microseconds.size() - 1)];
    };
    return microseconds.empty() ? QueryTimes() : QueryTimes{at(0.5), at(0.99)};
}

/// What both say to one pair after another.
class PairRuns {
public:
    PairRuns(const ExploredCampus& campus, NavMeshEngine* peer) : campus_(campus), peer_(peer) {
        const engine::ExploreSettings explored = campus.settings();
        settings_.strides = explored.strides;
        settings_.solids = explored.solids;
        settings_.ground = &ground_;
    }

    void run(const Pair& pair) {
        ++score_.pairs;
        const std::optional<double> ours = ours_from(pair);
        const std::optional<double> others = peer_ != nullptr ? peers_from(pair) : std::nullopt;
        if (ours && others) {
            ++score_.both;
            if (*ours >= kShortest && *others >= kShortest) {
                ratios_.push_back(*ours / *others);
            }
        }
    }

    RouteScore finished() {
        ask_again();
        score_.ours = times_of(std::move(our_times_));
        score_.again = times_of(std::move(times_again_));
        score_.walked = times_of(std::move(walk_times_));
        if (peer_ != nullptr) {
            score_.peer = times_of(std::move(peer_times_));
        }
        if (!ratios_.empty()) {
            score_.length_ratio = geometric_mean(ratios_);
        }
        return score_;
    }

private:
    struct Planned {
        engine::RouteRequest request;
        std::vector<engine::RoutePiece> pieces;
    };

    /// Its length, if there is one.
    std::optional<double> ours_from(const Pair& pair) {
        const engine::RouteRequest request{engine::state_of(pair.from), {{"goal", pair.to.foot, true}}};
        std::variant<Route, engine::NoRoute> found = plan_route(campus_.world(), settings_, request);
        our_times_.push_back(  // on ground that is known from the first time
            microseconds_of([&] { found = plan_route(campus_.world(), settings_, request); }));
        const Route* route = std::get_if<Route>(&found);
        score_.joined += pair.is_joined ? 1U : 0U;
        score_.found += pair.is_joined && route != nullptr ? 1U : 0U;
        score_.found_else += !pair.is_joined && route != nullptr ? 1U : 0U;
        if (route == nullptr) {
            if (pair.is_joined) {
                show("no route", pair);
            }
            return std::nullopt;
        }
        bool walked = false;
        walk_times_.push_back(
            microseconds_of([&] { walked = is_walked_as_planned(*route, pair.from, campus_); }));
        if (!walked) {
            ++score_.blocked;
            show("not walked as planned", pair);
        }
        remember(request, *route);
        return length_from_above(route->path);
    }

    /// As the step go_to does.
    engine::PlannedRoute ask(const engine::RouteRequest& request,
                             const std::function<engine::PlannedRoute()>& plan) {
        engine::GoToStep step;
        step.target = request.to.back();
        step.within = request.within;
        return cached_route({step, request.from, settings_}, memory_, plan);
    }

    void remember(const engine::RouteRequest& request, const Route& route) {
        ask(request, [&] { return engine::PlannedRoute{route}; });
        planned_.push_back({request, route.pieces});
    }

    void ask_again() {
        for (const Planned& planned : planned_) {
            const auto plan = [&] {
                const auto found = plan_route(campus_.world(), settings_, planned.request);
                return engine::PlannedRoute{std::get<Route>(found)};
            };
            engine::PlannedRoute again;
            times_again_.push_back(microseconds_of([&] { again = ask(planned.request, plan); }));
            score_.changed += std::ranges::equal(again.route.pieces, planned.pieces, is_same_piece) ? 0U : 1U;
        }
    }

    std::optional<double> peers_from(const Pair& pair) {
        bool found = peer_->path(pair.from.foot, pair.to.foot, vertices_);
        peer_times_.push_back(
            microseconds_of([&] { found = peer_->path(pair.from.foot, pair.to.foot, vertices_); }));
        if (!found || !ends_at(vertices_, pair.from.foot, pair.to.foot)) {
            return std::nullopt;
        }
        ++score_.by_peer;
        return length_from_above(vertices_);
    }

    void show(const char* what, const Pair& pair) {
        if (shown_++ < kFailuresShown) {
            std::printf("    %s from %.3f, %.3f, %.3f to %.3f, %.3f, %.3f\n", what, pair.from.foot.x(),
                        pair.from.foot.y(), pair.from.foot.z(), pair.to.foot.x(), pair.to.foot.y(),
                        pair.to.foot.z());
        }
    }

    const ExploredCampus& campus_;
    NavMeshEngine* peer_;
    engine::GroundMaps ground_;
    engine::RouteMemory memory_;
    engine::RouteSettings settings_;
    RouteScore score_;
    std::vector<double> our_times_;
    std::vector<Planned> planned_;
    std::vector<double> times_again_;
    std::vector<double> walk_times_;
    std::vector<double> peer_times_;
    std::vector<double> ratios_;
    std::vector<Vec3> vertices_;
    std::size_t shown_ = 0;
};

void print_score(const RouteScore& score) {
    std::printf(
        "  %zu pairs, %zu of them joined: %zu routes found, %zu in other pairs; %zu not walked as planned\n",
        score.pairs, score.joined, score.found, score.found_else, score.blocked);
    std::printf("    ours: %.0f us (median), %.0f us (p99); to walk them once: %.0f us, %.0f us\n",
                score.ours.median, score.ours.p99, score.walked.median, score.walked.p99);
    std::printf("    again: %.1f us (median), %.1f us (p99); %zu changed\n", score.again.median,
                score.again.p99, score.changed);
    if (score.peer) {
        std::printf("  detour: %.1f us (median), %.1f us (p99); arrives in %zu\n", score.peer->median,
                    score.peer->p99, score.by_peer);
        std::printf("    ratio: %.1fx (median), %.1fx (p99); again: %.1fx, %.1fx\n",
                    score.ours.median / score.peer->median, score.ours.p99 / score.peer->p99,
                    score.again.median / score.peer->median, score.again.p99 / score.peer->p99);
    }
    if (score.length_ratio) {
        std::printf("    length: %.4f of detour's in %zu pairs\n", *score.length_ratio, score.both);
    }
    std::fflush(stdout);
}

}  // namespace

RouteScore route_pairs(const ExploredCampus& campus, const WalkSpace& space, NavMeshEngine* peer,
                       std::size_t pairs) {
    PairRuns runs(campus, peer);
    if (peer != nullptr) {
        std::vector<Vec3> ignored;
        peer->path(campus.spawn, campus.spawn, ignored);  // links its polygons
    }
    for (const Pair& pair : random_pairs(campus, space, pairs)) {
        runs.run(pair);
    }
    RouteScore score = runs.finished();
    print_score(score);
    return score;
}

}  // namespace campuswalk::tools::bench
