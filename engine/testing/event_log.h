#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "engine/events/event.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

// For tests in C++ of whatever walks: keep a walk's events, then ask about them. Events are named as in
// walk.yaml: "KIND OBJECT" with globs in both, an object that is left out is any.

/// Hand it to run_walk; it keeps every event, the last being walk.end.
class EventLog final : public Observer {
public:
    void frame(const TickRecord& record) override;

    const std::vector<Event>& events() const { return events_; }

private:
    std::vector<Event> events_;
};

/// Whether something holds, and in a line what was found, for a test framework to print.
struct Verdict {
    bool holds = false;
    std::string found;

    explicit operator bool() const { return holds; }
    bool operator!() const { return !holds; }
};

std::ostream& operator<<(std::ostream& out, const Verdict& verdict);

/// The events come in this order; others may come between. A list without any holds.
Verdict has_sequence(const std::vector<Event>& events, const std::vector<std::string>& wanted);

/// No event fits.
Verdict has_never(const std::vector<Event>& events, const std::string& unwanted);

/// How many events fit.
std::size_t count_of(const std::vector<Event>& events, const std::string& pattern);

}  // namespace campuswalk::engine
