#include "engine/simulation/run_walk.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/expect/failure_scene.h"
#include "engine/simulation/simulation.h"

namespace campuswalk::engine {

namespace {

Event event_at(Tick tick, EventKind kind, std::string object) {
    Event event;
    event.tick = tick;
    event.kind = kind;
    event.object = std::move(object);
    return event;
}

/// The expectations that don't hold because the walk was stopped: "; the walk stops here, so what lines 9 and
/// 11 expect isn't evaluated".
std::string describe_undecided(const std::vector<Undecided>& undecided) {
    constexpr std::size_t kMaxListed = 8;
    std::vector<int> lines;
    for (const auto& [mark, holds_so_far] : undecided) {
        if (!holds_so_far && std::ranges::find(lines, mark.line) == lines.end()) {
            lines.push_back(mark.line);
        }
    }
    if (lines.empty()) {
        return "";
    }
    std::string list;
    for (std::size_t i = 0; i < std::min(lines.size(), kMaxListed); ++i) {
        const bool last = i + 1 == lines.size();
        list += (i == 0 ? "" : last ? " and " : ", ") + std::to_string(lines[i]);
    }
    list += lines.size() > kMaxListed ? ", …" : "";
    const bool one = lines.size() == 1;
    return "; the walk stops here, so what line" + std::string(one ? " " : "s ") + list +
           (one ? " expects" : " expect") + " isn't evaluated";
}

/// The failure's file if it is one that the walk includes, else empty.
std::string included_file(const Failure& failure, const Walk& walk) {
    const std::string& file = failure.mark.file;
    return file.empty() || walk.mark.file.empty() || file == walk.mark.file
               ? ""
               : std::filesystem::path(file).filename().string();
}

/// Adds the failures as events before the walk's last event, and the verdict to that.
void add_verdict(const WalkSummary& summary, const Walk& walk, std::vector<Event>& events) {
    Event end = std::move(events.back());
    events.pop_back();
    for (const Failure& failure : summary.failures) {
        Event& event = events.emplace_back(event_at(summary.ticks, EventKind::expect_fail, failure.code));
        event.fields = {{"line", static_cast<std::int64_t>(failure.mark.line)},
                        {"message", Text{failure.message}}};
        if (std::string file = included_file(failure, walk); !file.empty()) {
            event.fields.push_back({"file", std::move(file)});
        }
    }
    end.fields = {{"result", std::string(summary.passed ? "pass" : "fail")},
                  {"events", summary.events},
                  {"dist", Decimal{summary.distance, 3}},
                  {"hash", hexadecimal(summary.hash)}};
    events.push_back(std::move(end));
}

void summarize(const Simulation& simulation, const scene::Campus& campus, const Walk& walk,
               WalkSummary& summary) {
    const ExpectationSet& expectations = simulation.expectations();
    if (const auto& stop = simulation.stop()) {
        ExpectationSet::StoppedVerdicts verdicts = expectations.verdicts_when_stopped();
        summary.failures = std::move(verdicts.failures);
        FailureScene scene = stop->scene ? *stop->scene : scene_of(expectations.now(), campus, walk.avatar);
        if (stop->at) {
            scene.contact = stop->at;
        }
        Failure failure{
            stop->mark,       stop->code,   stop->message + describe_undecided(verdicts.undecided),
            std::move(scene), stop->reason, stop->object,
            stop->route,      stop->actual, stop->expected};
        if (!stop->scene) {
            add_obstacle(expectations.now(), failure);
        }
        summary.failures.insert(summary.failures.begin(), std::move(failure));
        summary.undecided = std::move(verdicts.undecided);
    } else {
        summary.failures = expectations.verdicts();
    }
    summary.passed = summary.failures.empty();
    summary.events += static_cast<std::int64_t>(summary.failures.size());
    summary.distance = simulation.distance();
    summary.hash = simulation.hash();
    summary.statistics = simulation.statistics();
}

WalkSummary run_walk(Simulation& simulation, const scene::Campus& campus, const Walk& walk,
                     std::span<Observer* const> observers) {
    WalkSummary summary;
    const auto show = [&](const TickRecord& record) {
        for (Observer* observer : observers) {
            observer->on_tick(record);
        }
    };

    for (Observer* observer : observers) {
        observer->begin(walk);
    }
    while (!simulation.finished()) {
        const TickRecord& record = simulation.step();
        summary.events += static_cast<std::int64_t>(record.events.size());
        summary.ticks = record.tick;
        show(record);
    }
    TickRecord last = simulation.close();
    // Neither walk.start nor walk.end is counted; expectations see walk.end without the verdict.
    summary.events += static_cast<std::int64_t>(last.events.size()) - 2;
    summarize(simulation, campus, walk, summary);
    std::vector<Event> closing(last.events.begin(), last.events.end());
    add_verdict(summary, walk, closing);
    last.events = closing;
    show(last);
    for (Observer* observer : observers) {
        observer->end();
    }
    return summary;
}

}  // namespace

WalkSummary run_walk(const scene::Campus& campus, const Walk& walk, std::span<Observer* const> observers,
                     RouteMemory* memory) {
    Simulation simulation(campus, walk, memory);
    return run_walk(simulation, campus, walk, observers);
}

WalkSummary run_walk(const scene::Campus& campus, const Walk& walk, IntentSource& intents,
                     std::span<Observer* const> observers) {
    Simulation simulation(campus, walk, intents);
    return run_walk(simulation, campus, walk, observers);
}

}  // namespace campuswalk::engine
