#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/world/obstacle.h"
#include "collision/world/placement.h"
#include "engine/events/decimals.h"
#include "engine/expect/finding.h"
#include "engine/script/avatar_body.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

// Evaluators of expectations about what happened to the avatar's body.

/// Queries the collision world independently of what the mover found.
template <>
class EvaluatorOf<ExpectNoPenetration> {
public:
    EvaluatorOf(const ExpectNoPenetration& expected, const EvaluatorContext& context)
        : expected_(&expected),
          campus_(&context.campus),
          avatar_(&context.avatar),
          ignored_layers_(ignored_layers(context.campus, context.avatar)) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        const double radius = avatar_->radius;
        const double height = record.avatar.stature * avatar_->height;
        const collision::Segment axis = collision::upright_axis(record.avatar.position, radius, height);
        const collision::QueryFilter filter{collision::Detection::solid, ignored_layers_, record.disabled};
        collision::gather_obstacles(campus_->world, filter, axis, radius, obstacles_);
        for (const collision::Obstacle& obstacle : obstacles_) {
            note_depth(obstacle.object, radius - collision::closest(axis, obstacle).distance, now);
        }
        // Deep inside a closed mesh its surface may be out of reach.
        const Eigen::Vector3d middle = 0.5 * (axis.a + axis.b);
        collision::Aabb box;
        box.extend(middle);
        campus_->world.candidates(box, filter, candidates_);
        for (const collision::ObjectId id : candidates_) {
            if (deepest_ < radius && collision::contains(campus_->world.object(id), middle)) {
                note_depth(id, radius, now);
            }
        }
    }

    static PossibleVerdicts possible(const ExpectNoPenetration& expected, const WalkBounds& bounds) {
        // Nothing is deeper in the body than its axis, whose distance from the skin is the radius.
        return {.fails = expected.tolerance < bounds.avatar().radius};
    }

    Finding finding(bool /*ended*/) const {
        constexpr double kMillimetres = 1000.0;
        if (!inside_) {
            return {true, expected_->mark, "the body was inside nothing", std::nullopt, true};
        }
        const bool tolerable = deepest_ <= expected_->tolerance;
        const std::string most = "at most " + fixed(expected_->tolerance * kMillimetres, 2) + " mm";
        const std::string& object = campus_->objects[*inside_].id;
        return {.holds = tolerable,
                .mark = expected_->mark,
                .message = "the body was " + fixed(deepest_ * kMillimetres, 2) + " mm inside " + object +
                           " " + at_time(when_->time),
                .when = when_,
                .can_change = tolerable,
                .expected = tolerable ? "" : most,
                .object = object};
    }

private:
    void note_depth(collision::ObjectId object, double depth, const StateSnapshot& now) {
        if (depth > deepest_) {
            deepest_ = depth;
            inside_ = index_of(object);
            when_ = now;
        }
    }

    const ExpectNoPenetration* expected_;
    const scene::Campus* campus_;
    const AvatarProfile* avatar_;
    std::uint32_t ignored_layers_;
    double deepest_ = 0.0;               ///< metres
    std::optional<std::size_t> inside_;  ///< the object that it was deepest in
    std::optional<StateSnapshot> when_;
    std::vector<collision::Obstacle> obstacles_;
    std::vector<collision::ObjectId> candidates_;
};

template <>
class EvaluatorOf<ExpectGrounded> {
public:
    EvaluatorOf(const ExpectGrounded& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        if (record.tick == last_) {
            return;
        }
        last_ = record.tick;
        ++ticks_;
        if (!record.avatar.grounded) {
            ++airborne_;
            if (!first_) {
                first_ = now;
            }
        }
    }

    static PossibleVerdicts possible(const ExpectGrounded& expected, const WalkBounds& bounds) {
        return {.fails = expected.ratio * bounds.ticks() > kRounding};
    }

    Finding finding(bool /*ended*/) const {
        if (airborne_ == 0) {
            return {true, expected_->mark, "the avatar was on the ground all the time", std::nullopt, true};
        }
        const double most = (1.0 - expected_->ratio) * static_cast<double>(ticks_);
        const bool few_enough = static_cast<double>(airborne_) <= most + kRounding;
        const bool always = expected_->ratio >= 1.0;
        const std::string share = "at most " + fixed(100.0 * (1.0 - expected_->ratio), 1) + " % of them";
        return {.holds = few_enough,
                .mark = expected_->mark,
                .message = "the avatar was off the ground in " + std::to_string(airborne_) + " of " +
                           std::to_string(ticks_) + " ticks, first " + at_time(first_->time),
                .when = first_,
                .can_change = !always,
                .expected = few_enough ? "" : share};
    }

private:
    static constexpr double kRounding = 1e-9;  // ticks

    const ExpectGrounded* expected_;
    Tick last_ = -1;  ///< the walk's closing record repeats its last tick
    Tick ticks_ = 0;
    Tick airborne_ = 0;
    std::optional<StateSnapshot> first_;
};

/// What the evaluators of `blocked_by` and `stuck` have in common.
class ObstructionFinder {
public:
    /// Of an event: the object in the way; empty when none could be named.
    static std::string obstacle_of(const Event& event) {
        const auto* name = find_field<std::string>(event, "by");
        return name != nullptr ? *name : "";
    }

    /// `verb` is "blocked" or "stuck". The words end with the reason that the event gives.
    void add(bool expected, const std::string& verb, const Event& event, const StateSnapshot& now) {
        if (!first_.empty()) {
            return;
        }
        object_ = obstacle_of(event);
        const Reason* why = reason_of(event);
        reason_ = why != nullptr ? std::optional(*why) : std::nullopt;
        const std::string what = verb + (object_.empty() ? " " : " by " + object_ + " ") + at_time(now.time) +
                                 (reason_ ? ": " + text_of(*reason_) : "");
        if (expected) {
            first_ = "the avatar was " + what;
            when_ = now;
        } else {
            other_ = what;
        }
    }

    Finding finding(const SourceMark& mark, const std::string& never) const {
        Finding found{!first_.empty(), mark, first_, when_};
        if (first_.empty()) {
            found.message = never + (other_.empty() ? "" : ", but " + other_);
            found.can_change = true;
        }
        found.reason = reason_;
        found.object = object_;
        return found;
    }

private:
    std::string first_;   ///< the first as expected, in words
    std::string other_;   ///< the last that wasn't as expected before that, in words
    std::string object_;  ///< of the one that counts: the object in the way
    std::optional<Reason> reason_;
    std::optional<StateSnapshot> when_;
};

template <>
class EvaluatorOf<ExpectBlockedBy> {
public:
    EvaluatorOf(const ExpectBlockedBy& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        for (const Event& event : record.events) {
            if (event.kind == EventKind::avatar_blocked || event.kind == EventKind::avatar_stuck) {
                const std::string object = ObstructionFinder::obstacle_of(event);
                const bool expected = !object.empty() && scene::glob_matches(expected_->object.glob, object);
                finder_.add(expected, "blocked", event, now);
            }
        }
    }

    static PossibleVerdicts possible(const ExpectBlockedBy& expected, const WalkBounds& bounds) {
        return {.holds =
                    bounds.moves() && bounds.can_contact(collision::Detection::solid, expected.object.glob)};
    }

    Finding finding(bool /*ended*/) const {
        return finder_.finding(expected_->mark,
                               "the avatar was never blocked by '" + expected_->object.glob + "'");
    }

private:
    const ExpectBlockedBy* expected_;
    ObstructionFinder finder_;
};

template <>
class EvaluatorOf<ExpectStuck> {
public:
    EvaluatorOf(const ExpectStuck& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        const std::string& glob = expected_->by.glob;
        for (const Event& event : record.events) {
            if (event.kind == EventKind::avatar_stuck) {
                const std::string object = ObstructionFinder::obstacle_of(event);
                const bool expected = glob == "*" || (!object.empty() && scene::glob_matches(glob, object));
                finder_.add(expected, "stuck", event, now);
            }
        }
    }

    static PossibleVerdicts possible(const ExpectStuck& expected, const WalkBounds& bounds) {
        return {.holds = bounds.moves() && bounds.can_contact(collision::Detection::solid, expected.by.glob)};
    }

    Finding finding(bool /*ended*/) const {
        const std::string& glob = expected_->by.glob;
        return finder_.finding(expected_->mark,
                               "the avatar was never stuck" + (glob == "*" ? "" : " by '" + glob + "'"));
    }

private:
    const ExpectStuck* expected_;
    ObstructionFinder finder_;
};

template <>
class EvaluatorOf<ExpectFell> {
public:
    EvaluatorOf(const ExpectFell& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        const bool falls =
            std::ranges::find(record.events, EventKind::avatar_fell, &Event::kind) != record.events.end();
        if (falls && !when_) {
            when_ = now;
        }
    }

    /// A fall stops the walk, so that no later step is left to expect it.
    static PossibleVerdicts possible(const ExpectFell& /*expected*/, const WalkBounds& bounds) {
        return {.holds = !bounds.in_step()};
    }

    Finding finding(bool /*ended*/) const {
        if (when_) {
            return {true, expected_->mark, "the avatar fell out of the world " + at_time(when_->time), when_};
        }
        return {false, expected_->mark, "the avatar did not fall out of the world", std::nullopt, true};
    }

private:
    const ExpectFell* expected_;
    std::optional<StateSnapshot> when_;
};

}  // namespace campuswalk::engine
