#pragma once

#include <vector>

#include "engine/expect/event_subjects.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::engine {

/// Finds what expectations name and the campus doesn't have: a `never` on a mistyped name would pass for
/// ever.
class NameCheck {
public:
    /// Both must outlive it.
    NameCheck(const scene::Campus& campus, const Walk& walk) : subjects_(campus, walk) {}

    /// Appends a diagnostic (unknown-name) about an event that can't happen.
    void check(const EventPattern& pattern, std::vector<scene::Diagnostic>& diagnostics) const;
    /// Appends those about all that the expectations name.
    void check(const std::vector<Expectation>& expectations,
               std::vector<scene::Diagnostic>& diagnostics) const;

private:
    void check(const Mention& mention, std::vector<scene::Diagnostic>& diagnostics) const;

    EventSubjects subjects_;
};

}  // namespace campuswalk::engine
