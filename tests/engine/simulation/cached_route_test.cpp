// Routes and reasons that were found before, by this process or another: the same again, and never another's.

#include "engine/simulation/cached_route.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

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

    /// Of a process that remembers nothing yet. `planned` is what would have to be planned.
    PlannedRoute answer(const PlannedRoute& planned) {
        RouteMemory memory;
        memory.cache = cache_;
        return answer(planned, memory);
    }
    PlannedRoute answer(const PlannedRoute& planned, RouteMemory& memory) {
        return cached_route({step_, state_, settings_}, memory, [&] {
            ++plans_;
            return planned;
        });
    }

    /// One thread, with a memory of its own as a worker has it, asks for what this one plans; this one goes
    /// on once that has had time to plan it as well. What each got, or what was thrown.
    std::pair<PlannedRoute, PlannedRoute> asked_at_once(const std::function<PlannedRoute()>& first,
                                                        const std::function<PlannedRoute()>& second) {
        const auto ask = [this](const std::function<PlannedRoute()>& plan) {
            RouteMemory memory;
            memory.cache = cache_;
            return cached_route({step_, state_, settings_}, memory, plan);
        };
        std::promise<void> first_plans;
        std::promise<void> second_plans;
        auto other = std::async(std::launch::async, [&] {
            first_plans.get_future().wait();
            return ask([&] {
                second_plans.set_value();
                return second();
            });
        });
        PlannedRoute own;
        try {
            own = ask([&] {
                first_plans.set_value();
                second_plans.get_future().wait_for(std::chrono::milliseconds(300));
                return first();
            });
        } catch (const std::runtime_error& error) {
            own.why_not = error.what();
        }
        return {own, other.get()};
    }

    std::vector<std::filesystem::path> route_files() const {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(home_.path())) {
            if (entry.path().filename().string().ends_with(".route.campuswalk")) {
                files.push_back(entry.path());
            }
        }
        return files;
    }

    support::TemporaryFolder home_;
    scene::CacheFolder folder_{home_.path()};
    RouteCache cache_{&folder_, scene::hash_of(std::as_bytes(std::span("campus")))};
    GoToStep step_;
    collision::MoverState state_;
    RouteSettings settings_;
    int plans_ = 0;
};

PlannedRoute searched() {
    PlannedRoute planned;
    planned.route.pieces = {{{"", {1.0 / 3.0, 0, 2}, false}, 0.05, std::nullopt, 17},
                            {{"desk", {4, 0.2, -12}, true}, 0.25, Vector3d(0.02, 0, 1e-9), 600}};
    planned.route.searched = true;
    return planned;
}

void expect_same(const PlannedRoute& a, const PlannedRoute& b) {
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

PlannedRoute no_route() {
    return {{}, "riser of 0.45 m at stair, 3.20, 0.45, -1.00; the avatar steps 0.30 m"};
}

TEST_F(CachedRoute, IsTheSameAgain) {
    answer(searched());
    expect_same(answer(no_route()), searched());
    EXPECT_EQ(plans_, 1);
}

TEST_F(CachedRoute, IsRememberedEvenIfItWasGuessed) {
    PlannedRoute guessed = searched();
    guessed.route.searched = false;
    RouteMemory memory;  // without a folder
    expect_same(answer(guessed, memory), guessed);
    expect_same(answer(no_route(), memory), guessed);
    EXPECT_EQ(plans_, 1);
    step_.within = 0.1;
    EXPECT_EQ(answer(no_route(), memory).why_not, no_route().why_not);
    EXPECT_EQ(plans_, 2);
}

TEST_F(CachedRoute, IsRememberedThoughItHasManyPieces) {
    PlannedRoute winding = searched();
    winding.route.pieces.resize(2000);
    RouteMemory memory;
    EXPECT_EQ(answer(winding, memory).route.pieces.size(), 2000U);
    EXPECT_EQ(answer(no_route(), memory).route.pieces.size(), 2000U);
    EXPECT_EQ(plans_, 1);
}

TEST_F(CachedRoute, RemembersOnlySoMany) {
    for (const std::size_t pieces : {1U, 300U}) {
        PlannedRoute planned = searched();
        planned.route.pieces.resize(pieces);
        RouteMemory memory;
        plans_ = 0;
        const int asked = pieces == 1 ? 30'000 : 2'000;
        for (int i = 0; i < asked; ++i) {
            step_.target.point.x() = i;
            answer(planned, memory);
            ASSERT_LE(memory.planned.size() * pieces, 200'000U);
        }
        EXPECT_EQ(plans_, asked);
        answer(no_route(), memory);
        EXPECT_EQ(plans_, asked) << "the last is remembered";
    }
}

TEST_F(CachedRoute, IsAnswerableWithoutItsFileOnceItIsKnown) {
    RouteMemory memory;
    memory.cache = cache_;
    answer(searched(), memory);
    for (const std::filesystem::path& file : route_files()) {
        std::filesystem::remove(file);
    }
    expect_same(answer(no_route(), memory), searched());
    EXPECT_EQ(plans_, 1);
}

TEST_F(CachedRoute, TellsWhyThereIsNone) {
    answer(no_route());
    EXPECT_EQ(answer(searched()).why_not, no_route().why_not);
    EXPECT_EQ(plans_, 1);
}

TEST_F(CachedRoute, IsNotWorthAFileIfItWasGuessed) {
    PlannedRoute guessed = searched();
    guessed.route.searched = false;
    answer(guessed);
    answer(guessed);
    EXPECT_EQ(plans_, 2);
    EXPECT_TRUE(route_files().empty());
}

TEST_F(CachedRoute, IsPlannedOnceForWorkersThatAskAtOnce) {
    std::atomic<int> plans = 0;
    const auto counted = [&](const PlannedRoute& planned) {
        return [&plans, planned] {
            ++plans;
            return planned;
        };
    };
    const auto [own, other] = asked_at_once(counted(no_route()), counted(searched()));
    EXPECT_EQ(plans, 1);
    expect_same(own, no_route());
    expect_same(other, no_route());
}

TEST_F(CachedRoute, IsPlannedByTheNextIfThatFails) {
    const auto fails = []() -> PlannedRoute { throw std::runtime_error("out of memory"); };
    const auto [own, other] = asked_at_once(fails, searched);
    EXPECT_EQ(own.why_not, "out of memory");
    expect_same(other, searched());
}

TEST_F(CachedRoute, ThatWasGuessedIsGuessedByEachWorker) {
    PlannedRoute guessed = searched();
    guessed.route.searched = false;
    const auto guess = [&] { return guessed; };
    const auto [own, other] = asked_at_once(guess, guess);
    expect_same(own, guessed);
    expect_same(other, guessed);
}

TEST_F(CachedRoute, IsOnlyForTheVerySame) {
    answer(no_route());
    std::vector<bool> disabled{false, true};
    const std::vector<std::function<void()>> changes = {
        [&] { cache_.campus.bytes[0] ^= 1; },
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

TEST_F(CachedRoute, IsPlannedAnewIfItsFileIsDamaged) {
    answer(no_route());
    ASSERT_EQ(route_files().size(), 1U);
    const std::filesystem::path file = route_files().front();
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
    EXPECT_FALSE(answer(searched()).route.pieces.empty());
    EXPECT_EQ(plans_, 2);
}

}  // namespace
}  // namespace campuswalk::engine
