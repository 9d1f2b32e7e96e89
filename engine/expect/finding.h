#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/events/event.h"
#include "engine/events/reason.h"
#include "engine/expect/state_snapshot.h"
#include "engine/expect/walk_bounds.h"
#include "engine/record/tick_record.h"
#include "engine/script/avatar.h"
#include "engine/script/expectation.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What an evaluator has found. `message` says what happened, whether expected or not: if `holds`, it is what
/// makes a `not` fail.
struct Finding {
    bool holds = false;
    SourceMark mark;                    ///< the part of the expectation to point at
    std::string message;                ///< one line
    std::optional<StateSnapshot> when;  ///< when it was decided; none: not before the end
    bool can_change = false;            ///< had the walk gone on, it might have turned out differently
    /// Set if it isn't known whether it holds: the code of what is lacking, see is_lack(). Then the
    /// expectation fails, and so does its `not`.
    std::string_view lack = {};
    std::string expected = {};          ///< instead, as in "at least 4", if it is put in so few words
    std::optional<Reason> reason = {};  ///< what the message words of a way
    std::string object = {};            ///< the one that the message is about, if any
};

/// What an expectation's verdict can be in some walk with these steps on this campus, or on one that differs
/// from it elsewhere. Where that isn't certain, it is possible.
struct PossibleVerdicts {
    bool holds = true;
    bool fails = true;
};

/// What evaluators are made from besides their expectation; all must outlive them.
struct EvaluatorContext {
    const scene::Campus& campus;
    const AvatarProfile& avatar;
};

/// The evaluator of one kind of expectation, which must outlive it. Specialized for each kind in
/// *_evaluators.h, always with these members:
///
///     EvaluatorOf(const Expected& expected, const EvaluatorContext& context);
///
///     // Every record, with the state at its end; the closing one repeats the last tick.
///     void on_tick(const TickRecord& record, const StateSnapshot& now);
///
///     // What holds so far; `ended`: nothing more will come.
///     Finding finding(bool ended) const;
///
///     // Whether its parameters can fail at all, and hold at all.
///     static PossibleVerdicts possible(const Expected& expected, const WalkBounds& bounds);
///
/// A copy continues independently.
template <typename Expected>
class EvaluatorOf;

/// The code of the failure that a finding is for an expectation of this name; nullopt if it is none.
std::optional<std::string> failure_code(const Finding& found, std::string_view name, bool negated);

// How findings are worded.

/// "popup.open library at 6.433 s"
std::string describe(const Event& event, double time);
/// "at 6.433 s"
std::string at_time(double time);
/// "once", "3 times"
std::string times_in_words(int count);
/// "1.250 m"
std::string in_metres(double value);

/// What a number should have been, as in "at least 2"; empty when it is.
std::string violated_limit(const Limits<int>& limits, int count);
/// The same; `unit` has a space before it. Prints three decimals, and numbers that agree in these are equal.
std::string violated_limit(const Limits<double>& limits, double value, const std::string& unit);
/// For numbers in the interval.
PossibleVerdicts possible_verdicts(const Limits<int>& limits, const Interval& numbers);
PossibleVerdicts possible_verdicts(const Limits<double>& limits, const Interval& numbers);

/// Whether a number that only grows may still come within its limits, or leave them.
bool can_still_change(const Limits<int>& limits, int count);
bool can_still_change(const Limits<double>& limits, double value);

}  // namespace campuswalk::engine
