// Routes and reasons that were found before: the same again, and never another's.

#include "engine/simulation/cached_route.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/engine/simulation/planned_routes.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

class CachedRoute : public testing::Test {
protected:
    CachedRoute() {
        step_.target = {"desk", {4, 0.2, -12}, true};
        state_.foot = {0, 0, 12};
        state_.grounded = true;
        settings_.strides.walk_speed = 1.4;
    }

    /// `planned` is what would have to be planned.
    PlannedRoute answer(const PlannedRoute& planned) {
        return cached_route({step_, state_, settings_}, memory_, [&] {
            ++plans_;
            return planned;
        });
    }

    RouteMemory memory_;
    GoToStep step_;
    collision::MoverState state_;
    RouteSettings settings_;
    int plans_ = 0;
};

/// Another process' route, whatever is asked for.
class OneRoute : public RouteStore {
public:
    explicit OneRoute(PlannedRoute route) : route_(std::move(route)) {}

    PlannedRoute stored_or_planned(const RouteKey& key, const std::function<PlannedRoute()>&) const override {
        asked_for.push_back(key);
        return route_;
    }

    mutable std::vector<RouteKey> asked_for;

private:
    PlannedRoute route_;
};

TEST_F(CachedRoute, IsTheSameAgain) {
    for (const bool was_searched : {true, false}) {  // guessed, it is remembered as well
        PlannedRoute planned = searched_route();
        planned.route.searched = was_searched;
        step_.within += 0.1;
        plans_ = 0;
        expect_same(answer(planned), planned);
        expect_same(answer(no_route()), planned);
        EXPECT_TRUE(answer(no_route()).route.path.empty()) << "it is far larger than the rest";
        EXPECT_EQ(plans_, 1);
    }
}

TEST_F(CachedRoute, IsRememberedThoughItHasManyPieces) {
    PlannedRoute winding = searched_route();
    winding.route.pieces.resize(2000);
    EXPECT_EQ(answer(winding).route.pieces.size(), 2000U);
    EXPECT_EQ(answer(no_route()).route.pieces.size(), 2000U);
    EXPECT_EQ(plans_, 1);
}

TEST_F(CachedRoute, RemembersOnlySoMany) {
    for (const std::size_t pieces : {1U, 300U}) {
        PlannedRoute planned = searched_route();
        planned.route.pieces.resize(pieces);
        memory_ = {};
        plans_ = 0;
        const int asked = pieces == 1 ? 30'000 : 2'000;
        for (int i = 0; i < asked; ++i) {
            step_.target.point.x() = i;
            answer(planned);
            ASSERT_LE(memory_.planned.size() * pieces, 200'000U);
        }
        EXPECT_EQ(plans_, asked);
        answer(no_route());
        EXPECT_EQ(plans_, asked) << "the last is remembered";
    }
}

TEST_F(CachedRoute, IsAskedForElsewhereOnlyUntilItIsKnown) {
    const auto other = std::make_shared<OneRoute>(searched_route());
    memory_.store = other;
    expect_same(answer(no_route()), searched_route());
    expect_same(answer(no_route()), searched_route());
    EXPECT_EQ(other->asked_for.size(), 1U);
    step_.within = 0.1;
    answer(no_route());
    ASSERT_EQ(other->asked_for.size(), 2U);
    EXPECT_NE(other->asked_for[0], other->asked_for[1]);
    EXPECT_EQ(plans_, 0);
}

TEST_F(CachedRoute, IsOnlyForTheVerySame) {
    answer(no_route());
    std::vector<bool> disabled{false, true};
    const std::vector<std::function<void()>> changes = {
        [&] { step_.target.point.y() += 1e-9; },
        [&] { step_.target.has_height = false; },
        [&] { step_.target.label = "table"; },
        [&] {
            step_.through.push_back({"gate", {0, 0, 0}, false});
        },
        [&] {
            step_.avoid.push_back({NamePattern{{}, "pond"}, {}, 0.0});
        },
        [&] { step_.avoid.back().objects->glob = "tree"; },
        [&] {
            step_.avoid.push_back({std::nullopt, {"", {1, 0, 1}, false}, 2.0});
        },
        [&] { step_.avoid.back().radius = 3.0; },
        [&] { step_.prefer = RoutePreference::wide; },
        [&] { step_.within = 0.1; },
        [&] { state_.foot.x() += 1e-12; },
        [&] { state_.support_y = 0.1; },
        [&] { state_.vertical_speed = -1.0; },
        [&] { state_.slide_velocity.z() = 0.5; },
        [&] { state_.fall_from = 2.0; },
        [&] { state_.grounded = false; },
        [&] { settings_.strides.walk_speed = 1.5; },
        [&] { settings_.strides.seconds = 1.0 / 30.0; },
        [&] { settings_.strides.body.height = 1.08; },
        [&] { settings_.strides.body.radius = 0.31; },
        [&] { settings_.strides.body.step_height = 0.4; },
        [&] { settings_.strides.body.min_up = 0.5; },
        [&] { settings_.strides.body.skin = 0.01; },
        [&] { settings_.strides.full_height = 1.8; },
        [&] { settings_.max_nodes = 1; },
        [&] { settings_.solids.ignored_layers = 2; },
        [&] { settings_.solids.detection = collision::Detection::trigger; },
        [&] { settings_.solids.disabled = &disabled; },
        [&] {
            disabled = {true, false};
        },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i]();
        answer(no_route());
        EXPECT_EQ(plans_, 2 + static_cast<int>(i)) << "change " << i;
    }
}

}  // namespace
}  // namespace campuswalk::engine
