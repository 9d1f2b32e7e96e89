#include "engine/run_walk.h"

#include <array>
#include <charconv>
#include <utility>

#include "collision/placement.h"
#include "engine/decimals.h"
#include "engine/expect/expectation_judge.h"
#include "engine/simulation.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

std::string hexadecimal(std::uint64_t value) {
    std::array<char, 16> digits{};
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16);
    const auto count = static_cast<std::size_t>(result.ptr - digits.data());
    return std::string(digits.size() - count, '0') + std::string(digits.data(), count);
}

/// The complaint about a place where the avatar can't stand, if it can't.
std::optional<scene::Diagnostic> check_place(const scene::Campus& campus, const Walk& walk,
                                             const SourceMark& mark, const std::string& label,
                                             const Vector3d& foot) {
    const AvatarProfile& a = walk.avatar;
    const collision::QueryFilter solids{collision::Detection::solid, ignored_layers(campus, a)};
    collision::QueryCounters counters;
    if (collision::free_place(campus.world, solids, foot, a.radius, a.height, kPlacementSearch, counters)) {
        return std::nullopt;
    }
    const auto object = collision::obstruction(campus.world, solids, foot, a.radius, a.height, counters);
    const std::string where = object ? "inside " + campus.objects[index_of(*object)].id : "not free";
    return scene::Diagnostic{scene::Severity::error, mark, "spawn-blocked",
                             label + " at " + fixed(foot) + " is " + where + ": put it where a capsule of " +
                                 fixed(a.radius, 2) + " m radius and " + fixed(a.height, 2) +
                                 " m height fits"};
}

/// The walk's last line and, before it, what was not as expected.
void add_verdict(const Walk& walk, const WalkSummary& summary, std::vector<Event>& events) {
    const auto add = [&](EventKind kind, std::string object) -> Event& {
        Event& event = events.emplace_back();
        event.tick = summary.ticks;
        event.kind = kind;
        event.object = std::move(object);
        return event;
    };
    for (const Failure& failure : summary.failures) {
        add(EventKind::expect_fail, failure.code).fields = {
            {"line", static_cast<std::int64_t>(failure.mark.line)}, {"message", Text{failure.message}}};
    }
    add(EventKind::walk_end, walk.name).fields = {{"result", std::string(summary.passed ? "pass" : "fail")},
                                                  {"events", summary.events},
                                                  {"dist", Decimal{summary.distance, 3}},
                                                  {"hash", hexadecimal(summary.hash)}};
}

}  // namespace

std::vector<scene::Diagnostic> check_walk(const scene::Campus& campus, const Walk& walk) {
    std::vector<scene::Diagnostic> complaints;
    for (const Step& step : walk.steps) {
        std::optional<scene::Diagnostic> complaint;
        if (const auto* spawn = std::get_if<SpawnStep>(&step)) {
            complaint = check_place(campus, walk, spawn->mark, spawn->label, spawn->position);
        } else if (const auto* teleport = std::get_if<TeleportStep>(&step)) {
            complaint = check_place(campus, walk, teleport->mark, teleport->label, teleport->position);
        }
        if (complaint) {
            complaints.push_back(std::move(*complaint));
        }
    }
    return complaints;
}

WalkSummary run_walk(const scene::Campus& campus, const Walk& walk, std::span<Observer* const> observers) {
    Simulation simulation(campus, walk);
    Jury jury(walk);
    WalkSummary summary;
    const auto show = [&](const FrameRecord& record) {
        for (Observer* observer : observers) {
            observer->frame(record);
        }
    };

    for (Observer* observer : observers) {
        observer->begin(walk);
    }
    while (!simulation.finished()) {
        const FrameRecord& record = simulation.step();
        jury.see(record);
        summary.events += static_cast<std::int64_t>(record.events.size());
        summary.ticks = record.tick;
        show(record);
    }

    FrameRecord last = simulation.leave_everything();
    jury.see(last);
    if (const auto& stop = simulation.stop()) {
        summary.failures.push_back({stop->mark, stop->code, stop->message});
    }
    for (Failure& failure : jury.verdicts()) {
        summary.failures.push_back(std::move(failure));
    }
    std::vector<Event> closing(last.events.begin(), last.events.end());
    summary.passed = summary.failures.empty();
    // walk.start is not counted; the failures are.
    summary.events += static_cast<std::int64_t>(closing.size() + summary.failures.size()) - 1;
    summary.distance = simulation.distance();
    summary.hash = simulation.hash();
    summary.counters = simulation.counters();
    add_verdict(walk, summary, closing);
    last.events = closing;
    show(last);
    for (Observer* observer : observers) {
        observer->end();
    }
    return summary;
}

}  // namespace campuswalk::engine
