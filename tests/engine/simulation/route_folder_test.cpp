// Routes and reasons that another process found before: the same again, and never another's.

#include "engine/simulation/route_folder.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/engine/simulation/planned_routes.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::engine {
namespace {

class StoredRoute : public testing::Test {
protected:
    /// What is stored; else `planned` had to be planned.
    PlannedRoute answer(const PlannedRoute& planned) {
        return store_.stored_or_planned(key_, [&] {
            ++plans_;
            return planned;
        });
    }

    /// One thread asks for what this one plans; this one goes on once that has had time to plan it as well.
    /// What each got, or what was thrown.
    std::pair<PlannedRoute, PlannedRoute> asked_at_once(const std::function<PlannedRoute()>& first,
                                                        const std::function<PlannedRoute()>& second) {
        std::promise<void> first_plans;
        std::promise<void> second_plans;
        auto other = std::async(std::launch::async, [&] {
            first_plans.get_future().wait();
            return store_.stored_or_planned(key_, [&] {
                second_plans.set_value();
                return second();
            });
        });
        PlannedRoute own;
        try {
            own = store_.stored_or_planned(key_, [&] {
                first_plans.set_value();
                second_plans.get_future().wait_for(std::chrono::milliseconds(300));
                return first();
            });
        } catch (const std::runtime_error& error) {
            own.why_not = Reason{.name = error.what()};
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
    scene::ContentHash campus_ = scene::hash_of(std::as_bytes(std::span("campus")));
    RouteFolder store_{folder_, campus_};
    RouteKey key_ = "from here to the desk";
    int plans_ = 0;
};

TEST_F(StoredRoute, IsTheSameAgain) {
    answer(searched_route());
    expect_same(answer(no_route()), searched_route());
    EXPECT_EQ(plans_, 1);
}

TEST_F(StoredRoute, IsOnlyForTheSameKeyAndCampus) {
    answer(no_route());
    key_ = "from here to the table";
    answer(searched_route());
    EXPECT_EQ(plans_, 2);
    campus_.bytes[0] ^= 1;
    RouteFolder(folder_, campus_).stored_or_planned(key_, [&] {
        ++plans_;
        return no_route();
    });
    EXPECT_EQ(plans_, 3);
    expect_same(answer(no_route()), searched_route());
}

TEST_F(StoredRoute, TellsWhyThereIsNone) {
    answer(no_route());
    EXPECT_EQ(answer(searched_route()).why_not, no_route().why_not);
    EXPECT_EQ(plans_, 1);
}

TEST_F(StoredRoute, TellsThatTheSearchWasCut) {
    answer({{}, Reason{.kind = ReasonKind::unsearched, .measured = 3.75e6}});
    const PlannedRoute again = answer(searched_route());
    ASSERT_TRUE(again.why_not);
    EXPECT_TRUE(is_unsearched(*again.why_not));
}

TEST_F(StoredRoute, IsNotWorthAFileIfItWasGuessed) {
    PlannedRoute guessed = searched_route();
    guessed.route.searched = false;
    answer(guessed);
    answer(guessed);
    EXPECT_EQ(plans_, 2);
    EXPECT_TRUE(route_files().empty());
}

TEST_F(StoredRoute, IsPlannedOnceForWorkersThatAskAtOnce) {
    std::atomic<int> plans = 0;
    const auto counted = [&](const PlannedRoute& planned) {
        return [&plans, planned] {
            ++plans;
            return planned;
        };
    };
    const auto [own, other] = asked_at_once(counted(no_route()), counted(searched_route()));
    EXPECT_EQ(plans, 1);
    expect_same(own, no_route());
    expect_same(other, no_route());
}

TEST_F(StoredRoute, IsPlannedByTheNextIfThatFails) {
    const auto fails = []() -> PlannedRoute { throw std::runtime_error("out of memory"); };
    const auto [own, other] = asked_at_once(fails, searched_route);
    EXPECT_EQ(own.why_not->name, "out of memory");
    expect_same(other, searched_route());
}

TEST_F(StoredRoute, ThatWasGuessedIsGuessedByEachWorker) {
    PlannedRoute guessed = searched_route();
    guessed.route.searched = false;
    const auto guess = [&] { return guessed; };
    const auto [own, other] = asked_at_once(guess, guess);
    expect_same(own, guessed);
    expect_same(other, guessed);
}

TEST_F(StoredRoute, IsPlannedAnewIfItsFileIsDamaged) {
    answer(no_route());
    ASSERT_EQ(route_files().size(), 1U);
    const std::filesystem::path file = route_files().front();
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
    EXPECT_FALSE(answer(searched_route()).route.pieces.empty());
    EXPECT_EQ(plans_, 2);
}

}  // namespace
}  // namespace campuswalk::engine
