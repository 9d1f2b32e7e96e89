#pragma once

#include <optional>
#include <string>

#include "engine/events/event.h"
#include "engine/expect/state_snapshot.h"
#include "engine/script/avatar.h"
#include "engine/script/expectation.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What a judge has to say of an expectation. `told` says what happened, whether that is as expected or not:
/// of what is met, `not` makes a failure.
struct Finding {
    bool met = false;
    SourceMark mark;                    ///< what of the expectation to point at
    std::string told;                   ///< on a line
    std::optional<StateSnapshot> when;  ///< when it was decided; none: not before the end
    bool open = false;                  ///< had the walk gone on, it might have become otherwise
};

/// What evaluators are made from besides their expectation; all must outlive them.
struct EvaluatorContext {
    const scene::Campus& campus;
    const AvatarProfile& avatar;
};

// How findings are worded.

/// "popup.open library at 6.433 s"
std::string told(const Event& event, double time);
/// "at 6.433 s"
std::string at_time(double time);
/// "once", "3 times"
std::string told_times(int count);

// What a number should have been, "at least 2"; empty when it is.

std::string broken_limit(const Limits<int>& limits, int count);
/// Whether a number that only grows may still come within its limits, or leave them.
bool still_open(const Limits<int>& limits, int count);
bool still_open(const Limits<double>& limits, double value);
/// `unit` with a space before it; three decimals are told, and to three they are equal.
std::string broken_limit(const Limits<double>& limits, double value, const std::string& unit);

}  // namespace campuswalk::engine
