#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "engine/events/event.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

// For tests in C++ of anything that walks: record a walk's events, then query them. Events are written as in
// walk.yaml: "KIND OBJECT" with globs in both; without an object, of any object.

/// An observer for run_walk that stores all events; the last is walk.end.
class EventLog final : public Observer {
public:
    void on_tick(const TickRecord& record) override;

    const std::vector<Event>& events() const { return events_; }

private:
    std::vector<Event> events_;
};

/// Whether something holds and, in one line, what was found, for a test framework to print.
struct Verdict {
    bool holds = false;
    std::string found;

    explicit operator bool() const { return holds; }
    bool operator!() const { return !holds; }
};

std::ostream& operator<<(std::ostream& out, const Verdict& verdict);

/// The events come in this order; others may come between. Holds for an empty list.
Verdict has_sequence(const std::vector<Event>& events, const std::vector<std::string>& patterns);

/// No event matches.
Verdict has_never(const std::vector<Event>& events, const std::string& pattern);

/// How many events match.
std::size_t count_of(const std::vector<Event>& events, const std::string& pattern);

}  // namespace campuswalk::engine
