#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"

// Random walks through random campuses: whatever happens, contacts follow the grammar ENTER STAY* EXIT, and
// pop-ups follow their contacts.

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;

constexpr std::array kBuildings = {"hall", "tower", "shed"};

/// Boxes in all detection modes, up to 4 m high, away from the origin. Some are in the layer "hidden".
scene::Campus random_campus(support::Dice& dice) {
    scene::Campus campus = level_campus(30.0);
    for (const char* building : kBuildings) {
        add_building(campus, building);
    }
    campus.description.layers = {"hidden"};
    for (int i = 0; i < 40; ++i) {
        Vector3d center = dice.in_cube(12.0);
        center.y() = dice.between(0.0, 2.0);
        const Vector3d half(dice.between(0.05, 1.5), dice.between(0.2, 2.0), dice.between(0.05, 1.5));
        if (std::abs(center.x()) < half.x() + 0.5 && std::abs(center.z()) < half.z() + 0.5) {
            continue;
        }
        const auto detection = static_cast<Detection>(1 + dice.below(7));
        ObjectTraits traits{detection, "", dice.chance(0.8), dice.chance(0.2) ? "hidden" : ""};
        if (dice.chance(0.6)) {
            traits.building = kBuildings[static_cast<std::size_t>(dice.below(3))];
        }
        const std::string prefix = traits.layer.empty() ? "box/" : "hidden/";
        add_box(campus, prefix + std::to_string(i), center - half, center + half, traits);
    }
    return campus;
}

Walk random_walk(support::Dice& dice) {
    std::vector<Step> steps = {spawn_at({0, 0, 0})};
    for (int i = 0; i < 12; ++i) {
        WalkToStep step = walk_to(dice.between(-13, 13), dice.between(-13, 13));
        step.if_blocked = IfBlocked::proceed;
        step.timeout = 4.0;
        step.speed = dice.chance(0.2) ? 30.0 : dice.between(1.0, 4.0);
        steps.emplace_back(step);
        if (dice.chance(0.3)) {
            steps.emplace_back(turn_by(dice.between(-400, 400)));
        }
        if (dice.chance(0.3)) {
            steps.emplace_back(dice.chance(0.5) ? disable("box/" + std::to_string(dice.below(4)) + "*")
                                                : enable("box/*"));
        }
        if (dice.chance(0.2)) {
            steps.emplace_back(set_height(dice.between(0.6, 1.8)));
        }
        if (dice.chance(0.2)) {
            steps.emplace_back(jump_up(dice.between(1.0, 5.0), dice.between(0.0, 4.0)));
        }
        if (dice.chance(0.2)) {
            FollowStep curve = follow({{dice.between(-9, 9), 0, 0}, {0, 0, dice.between(-9, 9)}});
            curve.if_blocked = IfBlocked::proceed;
            curve.timeout = 4.0;
            steps.emplace_back(curve);
        }
        if (dice.chance(0.2)) {
            const bool in_the_air = dice.chance(0.5);
            steps.emplace_back(teleport_to(
                in_the_air ? Vector3d(dice.between(-12, 12), 6, dice.between(-12, 12)) : Vector3d::Zero()));
        }
    }
    Walk walk = walk_of(std::move(steps));
    walk.avatar.ignore_layers = {"hidden"};
    walk.sim.stay_every = 0.05 * dice.below(5);
    return walk;
}

/// Checks every event against the grammar.
class GrammarCheck final : public Observer {
public:
    GrammarCheck(const scene::Campus& campus, Tick stay_ticks) : campus_(campus), stay_ticks_(stay_ticks) {}

    void on_tick(const TickRecord& record) override {
        at_ = 0.0;
        for (const Event& event : record.events) {
            if (testing::Test::HasFatalFailure()) {
                return;
            }
            EXPECT_EQ(event.tick, record.tick);
            check(event);
        }
        EXPECT_FALSE(opens_next_) << "an enter without its pop-up";
        EXPECT_FALSE(closed_) << "a pop-up that closed without an exit";
        std::vector<std::size_t> shown;
        for (const OpenPopup& popup : record.open_popups) {
            shown.push_back(popup.building);
        }
        EXPECT_EQ(shown, open_);
    }
    void end() override {
        EXPECT_TRUE(since_.empty()) << "a contact without an exit";
        EXPECT_TRUE(open_.empty());
    }

    std::map<std::string, int> seen;  ///< how often each kind occurred

private:
    using Contact = std::pair<std::string, std::string>;  // mode, object

    void check(const Event& event) {
        const std::string kind(name_of(event.kind));
        ++seen[kind];
        const std::string mode = kind.substr(0, kind.find('.'));
        if (opens_next_) {
            ASSERT_EQ(event_line(event), "popup.open " + *opens_next_);
        }
        if (mode == "popup") {
            check_popup(event);
        } else if (mode == "collision" || mode == "trigger" || mode == "ray") {
            ASSERT_FALSE(event.object.starts_with("hidden/"));
            check_order(event);
            check_contact(event, {mode, event.object});
        } else if (kind == "avatar.teleport") {
            ASSERT_TRUE(since_.empty()) << "still in contact with the old place";
            at_ = 0.0;
        }
    }

    void check_order(const Event& event) {
        ASSERT_GE(event.at, at_) << event_line(event);
        ASSERT_LE(event.at, 1.0);
        at_ = event.at;
    }

    void check_contact(const Event& event, const Contact& contact) {
        const std::string phase(name_of(event.kind).substr(contact.first.size() + 1));
        const auto known = since_.find(contact);
        ASSERT_EQ(known != since_.end(), phase != "enter") << event_line(event);
        if (phase == "enter") {
            since_[contact] = event.tick;
            count_enter(event);
            return;
        }
        const Tick ticks = event.tick - known->second;
        ASSERT_EQ(field<std::int64_t>(event, "ticks"), ticks) << event_line(event);
        if (phase == "stay") {
            ASSERT_GT(ticks, 0);
            ASSERT_EQ(ticks % stay_ticks_, 0) << event_line(event);
        } else {
            since_.erase(known);
            count_exit(event);
        }
    }

    std::optional<std::size_t> shown_building(const Event& event) const {
        const auto object = std::ranges::find(campus_.objects, event.object, &scene::CampusObject::id);
        return object->popup ? object->building : std::nullopt;
    }

    void count_enter(const Event& event) {
        const auto building = shown_building(event);
        if (building && touched_[*building]++ == 0) {
            opens_next_ = campus_.description.buildings[*building].id;
        }
    }

    void count_exit(const Event& event) {
        const auto building = shown_building(event);
        const bool last = building && --touched_[*building] == 0;
        ASSERT_EQ(closed_.has_value(), last) << event_line(event);
        if (last) {
            ASSERT_EQ(*closed_, campus_.description.buildings[*building].id);
        }
        closed_.reset();
    }

    void check_popup(const Event& event) {
        const auto& buildings = campus_.description.buildings;
        const auto index = static_cast<std::size_t>(
            std::ranges::find(buildings, event.object, &scene::Building::id) - buildings.begin());
        if (event.kind == EventKind::popup_open) {
            ASSERT_TRUE(opens_next_) << event_line(event);
            opens_next_.reset();
            open_.push_back(index);
        } else {
            ASSERT_FALSE(closed_) << "two pop-ups closed before one exit";
            closed_ = event.object;
            ASSERT_EQ(std::erase(open_, index), 1U) << event_line(event);
        }
    }

    const scene::Campus& campus_;
    Tick stay_ticks_;
    std::map<Contact, Tick> since_;
    std::map<std::size_t, int> touched_;
    std::vector<std::size_t> open_;
    std::optional<std::string> opens_next_;
    std::optional<std::string> closed_;
    double at_ = 0.0;
};

TEST(EventGrammar, HoldsOnRandomWalks) {
    std::map<std::string, int> seen;
    for (std::uint32_t seed = 1; seed <= static_cast<std::uint32_t>(support::repeats(60)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        support::Dice dice(seed);
        const scene::Campus campus = random_campus(dice);
        const Walk walk = random_walk(dice);
        const auto stay_ticks = std::max<Tick>(1, static_cast<Tick>(std::lround(walk.sim.stay_every * 60.0)));
        GrammarCheck grammar(campus, stay_ticks);
        const std::array<Observer*, 1> observers = {&grammar};
        run_walk(campus, walk, observers);
        for (const auto& [kind, times] : grammar.seen) {
            seen[kind] += times;
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    for (const char* kind :
         {"collision.enter", "collision.stay", "trigger.enter", "trigger.stay", "ray.enter", "ray.stay",
          "popup.open", "avatar.teleport", "avatar.blocked", "avatar.landed", "avatar.stuck", "avatar.jump",
          "avatar.crouch", "object.enable", "object.disable"}) {
        EXPECT_GT(seen[kind], 5) << kind << " must occur often enough to be tested";
    }
}

}  // namespace
}  // namespace campuswalk::engine
