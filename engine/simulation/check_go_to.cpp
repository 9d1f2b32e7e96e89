#include "engine/simulation/check_go_to.h"

#include <algorithm>
#include <variant>

#include "engine/simulation/simulation.h"

namespace campuswalk::engine {

namespace {

bool is_go_to(const Step& step) {
    return std::holds_alternative<GoToStep>(step);
}

bool must_be_unreachable(const WalkStatus& status) {
    return status.kind == WalkStatus::Kind::xfail &&
           (status.codes.empty() || std::ranges::find(status.codes, kUnreachableCode) != status.codes.end());
}

/// What comes after the last go_to doesn't matter.
void end_with_go_to(std::vector<Step>& steps) {
    const auto last = std::find_if(steps.rbegin(), steps.rend(), is_go_to);
    steps.erase(last.base(), steps.end());
}

/// The walk as far as it moves the avatar to a go_to.
Walk moves_of(const Walk& walk) {
    Walk moves = walk;
    moves.expectations.clear();
    std::erase_if(moves.steps, [](const Step& step) {
        return std::holds_alternative<ExpectStep>(step) || std::holds_alternative<SnapshotStep>(step);
    });
    end_with_go_to(moves.steps);
    return moves;
}

}  // namespace

std::vector<scene::Diagnostic> check_go_to(const scene::Campus& campus, const Walk& walk,
                                           RouteMemory* memory) {
    std::vector<scene::Diagnostic> diagnostics;
    if (std::ranges::none_of(walk.steps, is_go_to) || walk.status.kind == WalkStatus::Kind::skip ||
        must_be_unreachable(walk.status)) {
        return diagnostics;
    }
    for (Walk moves = moves_of(walk); !moves.steps.empty(); end_with_go_to(moves.steps)) {
        Simulation simulation(campus, moves, memory);
        while (!simulation.finished()) {
            simulation.step();
        }
        const std::optional<Stop>& stop = simulation.stop();
        if (!stop || stop->code != kUnreachableCode) {
            break;
        }
        diagnostics.push_back({scene::Severity::warning, stop->mark, "unreachable-place", stop->message});
        // In all rounds of a `repeat`.
        std::erase_if(moves.steps, [&](const Step& step) { return mark_of(step) == stop->mark; });
    }
    return diagnostics;
}

}  // namespace campuswalk::engine
