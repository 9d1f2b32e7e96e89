#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/world/obstacle.h"
#include "engine/expect/finding.h"
#include "engine/record/tick_record.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

// Judges of what became of the avatar's body; see event_evaluators.h.

/// Asks the collision world about the body anew, whatever the mover thought.
class NoPenetrationEvaluator {
public:
    NoPenetrationEvaluator(const ExpectNoPenetration& expected, const scene::Campus& campus,
                           const AvatarProfile& avatar);
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    void see_depth(collision::ObjectId object, double depth, const StateSnapshot& now);

    const ExpectNoPenetration* expected_;
    const scene::Campus* campus_;
    const AvatarProfile* avatar_;
    std::uint32_t ignored_layers_;
    double deepest_ = 0.0;               ///< metres
    std::optional<std::size_t> inside_;  ///< the object that it was deepest in
    std::optional<StateSnapshot> when_;
    std::vector<collision::Obstacle> pieces_;
    std::vector<collision::ObjectId> around_;
};

class GroundedEvaluator {
public:
    explicit GroundedEvaluator(const ExpectGrounded& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectGrounded* expected_;
    Tick last_ = -1;  ///< the walk's closing frame shows its last tick again
    Tick ticks_ = 0;
    Tick airborne_ = 0;
    std::optional<StateSnapshot> first_;
};

class BlockedByEvaluator {
public:
    explicit BlockedByEvaluator(const ExpectBlockedBy& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectBlockedBy* expected_;
    std::string first_;  ///< by what, as it would be told
    std::string other_;  ///< the last that was in the way instead
    std::optional<StateSnapshot> when_;
};

class StuckEvaluator {
public:
    explicit StuckEvaluator(const ExpectStuck& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectStuck* expected_;
    std::string first_;
    std::string other_;
    std::optional<StateSnapshot> when_;
};

class FellEvaluator {
public:
    explicit FellEvaluator(const ExpectFell& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectFell* expected_;
    std::optional<StateSnapshot> when_;
};

inline NoPenetrationEvaluator evaluator_of(const ExpectNoPenetration& expected,
                                           const EvaluatorContext& context) {
    return NoPenetrationEvaluator(expected, context.campus, context.avatar);
}
inline GroundedEvaluator evaluator_of(const ExpectGrounded& expected, const EvaluatorContext&) {
    return GroundedEvaluator(expected);
}
inline BlockedByEvaluator evaluator_of(const ExpectBlockedBy& expected, const EvaluatorContext&) {
    return BlockedByEvaluator(expected);
}
inline StuckEvaluator evaluator_of(const ExpectStuck& expected, const EvaluatorContext&) {
    return StuckEvaluator(expected);
}
inline FellEvaluator evaluator_of(const ExpectFell& expected, const EvaluatorContext&) {
    return FellEvaluator(expected);
}

}  // namespace campuswalk::engine
