#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "engine/expect/body_evaluators.h"
#include "engine/expect/event_evaluators.h"
#include "engine/expect/expectation_set.h"
#include "engine/expect/path_evaluators.h"
#include "engine/expect/popup_evaluators.h"
#include "engine/expect/route_evaluators.h"

namespace campuswalk::engine {

/// The evaluator of each expectation, in the same order; one without doesn't compile.
template <typename... Expected>
std::variant<EvaluatorOf<Expected>...> each_evaluator(const std::variant<Expected...>&);
using PlainEvaluator = decltype(each_evaluator(std::declval<PlainExpectation>()));

/// Evaluates one expectation over a walk's tick records.
class Evaluator {
public:
    /// What it refers to must outlive it. None for those that are evaluated elsewhere: logs and images.
    static std::optional<Evaluator> of(const Expectation& expectation, const scene::Campus& campus,
                                       const AvatarProfile& avatar);

    void on_tick(const TickRecord& record, const StateSnapshot& now);

    /// Why the expectation doesn't hold for what has been seen, if it doesn't; if it wasn't decided earlier,
    /// it is decided `now`.
    std::optional<Failure> failure(bool ended, const StateSnapshot& now) const;

    /// At the walk's end, if the verdict might have been another had the walk gone on.
    std::optional<Undecided> undecided() const;
    /// The part of the expectation that decides so far.
    SourceMark mark() const { return finding(false).mark; }

private:
    Finding finding(bool ended) const;

    Evaluator(PlainEvaluator evaluator, const scene::Campus& campus, const AvatarProfile& avatar)
        : evaluator_(std::move(evaluator)), campus_(&campus), avatar_(&avatar) {}

    PlainEvaluator evaluator_;
    std::string_view name_;
    bool negated_ = false;
    const scene::Campus* campus_;
    const AvatarProfile* avatar_;
};

}  // namespace campuswalk::engine
