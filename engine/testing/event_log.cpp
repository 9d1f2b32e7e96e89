#include "engine/testing/event_log.h"

#include <algorithm>
#include <ostream>

#include "engine/record/tick_record.h"
#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

namespace {

EventPattern pattern_from(const std::string& text) {
    EventPattern pattern;
    const std::size_t space = text.find(' ');
    pattern.kind = text.substr(0, space);
    if (const std::size_t object = text.find_first_not_of(' ', space); object != std::string::npos) {
        pattern.object = text.substr(object);
    }
    return pattern;
}

std::string describe(const Event& event) {
    return std::string(name_of(event.kind)) + " " + event.object + " in tick " + std::to_string(event.tick);
}

}  // namespace

void EventLog::on_tick(const TickRecord& record) {
    events_.insert(events_.end(), record.events.begin(), record.events.end());
}

std::ostream& operator<<(std::ostream& out, const Verdict& verdict) {
    return out << verdict.found;
}

Verdict has_sequence(const std::vector<Event>& events, const std::vector<std::string>& patterns) {
    std::string last = "the walk's start";
    auto from = events.begin();
    for (const std::string& text : patterns) {
        const EventPattern pattern = pattern_from(text);
        from = std::find_if(from, events.end(), [&](const Event& event) { return matches(pattern, event); });
        if (from == events.end()) {
            return {false, std::string("no ").append(text).append(" after ").append(last)};
        }
        last = describe(*from++);
    }
    return {true, "all occurred, the last being " + last};
}

Verdict has_never(const std::vector<Event>& events, const std::string& text) {
    const EventPattern pattern = pattern_from(text);
    const auto found =
        std::ranges::find_if(events, [&](const Event& event) { return matches(pattern, event); });
    return found == events.end() ? Verdict{true, "no " + text} : Verdict{false, describe(*found)};
}

std::size_t count_of(const std::vector<Event>& events, const std::string& text) {
    const EventPattern pattern = pattern_from(text);
    return static_cast<std::size_t>(
        std::ranges::count_if(events, [&](const Event& event) { return matches(pattern, event); }));
}

}  // namespace campuswalk::engine
