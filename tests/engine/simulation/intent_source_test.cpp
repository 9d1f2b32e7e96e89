// Intent sources other than the script.

#include "engine/script/intent.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/script/player.h"
#include "engine/simulation/simulation.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using testing::ElementsAre;

/// What a source returned in one tick.
struct Answers {
    Intent intent;
    std::optional<StepEnd> end;
    std::vector<const Step*> instant;
    bool finished = false;
};

/// Records the answers of another source.
class Recording final : public IntentSource {
public:
    explicit Recording(IntentSource& source) : source_(source) {}

    Intent intend(const AvatarState& avatar) override {
        ticks_.push_back({source_.intend(avatar), {}, {}, false});
        return ticks_.back().intent;
    }
    void on_events(std::span<const Event> events) override { source_.on_events(events); }
    std::optional<StepEnd> settle(const AvatarState& avatar, std::vector<const Step*>& instant) override {
        Answers& now = ticks_.back();
        now.end = source_.settle(avatar, now.instant);
        now.finished = source_.finished();
        instant.insert(instant.end(), now.instant.begin(), now.instant.end());
        return now.end;
    }
    bool finished() const override { return source_.finished(); }

    const std::vector<Answers>& ticks() const { return ticks_; }

private:
    IntentSource& source_;
    std::vector<Answers> ticks_;
};

/// Replays recorded answers, whatever the avatar does.
class Playback final : public IntentSource {
public:
    explicit Playback(const std::vector<Answers>& ticks) : ticks_(ticks) {}

    Intent intend(const AvatarState&) override { return ticks_.at(next_++).intent; }
    std::optional<StepEnd> settle(const AvatarState&, std::vector<const Step*>& instant) override {
        const Answers& now = ticks_.at(next_ - 1);
        instant.insert(instant.end(), now.instant.begin(), now.instant.end());
        return now.end;
    }
    bool finished() const override { return next_ == ticks_.size(); }

private:
    const std::vector<Answers>& ticks_;
    std::size_t next_ = 0;
};

/// A floor with a gate that can be disabled, a hall with a pop-up, and a kerb.
scene::Campus varied_campus() {
    scene::Campus campus = level_campus();
    add_building(campus, "hall", "Great Hall");
    add_box(campus, "hall/inside", {-2, 0, -6}, {2, 3, -3},
            {collision::Detection::trigger, "hall", true, ""});
    add_box(campus, "gate", {-5, 0, -9}, {5, 3, -8});
    add_box(campus, "kerb", {-5, 0, -2}, {5, 0.2, -1.5});
    return campus;
}

/// All kinds of motion that a script can ask for, and steps with and without duration.
Walk varied_walk() {
    WalkToStep against_the_gate = walk_to(0, -11);
    against_the_gate.if_blocked = IfBlocked::proceed;
    return walk_of({spawn_at({0, 0, 2}), walk_to(0, -4), snapshot("hall"), jump_up(2.5, 1.0),
                    against_the_gate, set_height(1.1), follow({{1, 0, -6}, {-1, 0, -5}}), set_height(1.8),
                    turn_by(-200), disable("gate"), walk_to(0, -11), teleport_to({3, 0, 3}), wait_for(0.3)});
}

TEST(IntentSource, ReplaysAScriptFromItsRecordedIntents) {
    const scene::Campus campus = varied_campus();
    const Walk walk = varied_walk();
    ScriptPlayer script(walk);
    Recording recording(script);
    Recorder first;
    const WalkSummary recorded = run_walk(campus, walk, recording, std::array<Observer*, 1>{&first});
    ASSERT_TRUE(recorded.passed);
    ASSERT_EQ(recorded.hash, run(campus, walk).summary.hash) << "recording changes nothing";

    Playback playback(recording.ticks());
    Recorder second;
    const WalkSummary played = run_walk(campus, walk, playback, std::array<Observer*, 1>{&second});
    EXPECT_EQ(played.hash, recorded.hash);
    EXPECT_EQ(played.ticks, recorded.ticks);
    EXPECT_EQ(second.event_lines(), first.event_lines());
    EXPECT_EQ(second.states().size(), first.states().size());
}

TEST(IntentSource, ChangesTheWalkIfAnIntentChanges) {
    const scene::Campus campus = varied_campus();
    const Walk walk = varied_walk();
    ScriptPlayer script(walk);
    Recording recording(script);
    const WalkSummary recorded = run_walk(campus, walk, recording, {});
    std::vector<Answers> ticks = recording.ticks();
    ticks.at(100).intent.move *= 0.5;
    Playback playback(ticks);
    EXPECT_NE(run_walk(campus, walk, playback, {}).hash, recorded.hash);
}

/// Has no steps: walks north until a pop-up opens, and stays there for a while.
class Visitor final : public IntentSource {
public:
    Intent intend(const AvatarState& avatar) override {
        Intent intent;
        intent.yaw = avatar.yaw;
        if (!placed_) {
            intent.placement = {&kName, {0, 0, 0}, EventKind::avatar_spawn};
            placed_ = true;
        } else if (left_ == kStay) {
            intent.move = {0, 0, -0.02};
        }
        return intent;
    }
    void on_events(std::span<const Event> events) override {
        for (const Event& event : events) {
            seen_ = seen_ || event.kind == EventKind::popup_open;
        }
        left_ -= seen_ ? 1 : 0;
    }
    bool finished() const override { return left_ <= 0; }

private:
    static constexpr int kStay = 30;
    static inline const std::string kName = "visitor";
    bool placed_ = false;
    bool seen_ = false;
    int left_ = kStay;
};

TEST(IntentSource, DrivesAWalkWithoutSteps) {
    const scene::Campus campus = varied_campus();
    Walk walk = walk_of({});
    walk.expectations = {expect_never("avatar.*"), expect_count("popup.open hall", 2, {}, {}, 9)};
    Visitor visitor;
    Recorder recorder;
    const WalkSummary summary = run_walk(campus, walk, visitor, std::array<Observer*, 1>{&recorder});
    EXPECT_THAT(recorder.event_lines(),
                ElementsAre("trigger.enter hall/inside", "popup.open hall", "popup.close hall",
                            "trigger.exit hall/inside", "expect.fail count"));
    ASSERT_EQ(summary.failures.size(), 1U) << "the walk's expectations apply to every source";
    EXPECT_EQ(summary.failures.front().mark.line, 9);
}

TEST(IntentSource, StopsAtTheWalksTimeout) {
    const scene::Campus campus = level_campus();
    Walk walk = walk_of({});
    walk.mark = {"a.walk.yaml", 1, 1};
    walk.timeout = 0.5;
    Visitor visitor;
    const WalkSummary summary = run_walk(campus, walk, visitor, {});
    EXPECT_EQ(summary.ticks, 30);
    ASSERT_EQ(summary.failures.size(), 1U);
    EXPECT_EQ(summary.failures.front().code, "timeout");
    EXPECT_EQ(summary.failures.front().mark.line, 1) << "the line of the walk, not of a step";
}

}  // namespace
}  // namespace campuswalk::engine
