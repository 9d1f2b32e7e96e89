#pragma once

#include <string>
#include <vector>

#include "engine/expect/event_subjects.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::engine {

/// Finds names in steps and expectations that the campus and the walk don't have: a `never` with a mistyped
/// name would always pass. Its diagnostics are `unknown-name`.
class NameCheck {
public:
    /// All must outlive it.
    NameCheck(const scene::Campus& campus, const Walk& walk, std::vector<scene::Diagnostic>& diagnostics);

    /// Reports the mentioned events that can't happen.
    void check_events(const std::vector<Mention>& mentions) const;
    /// Reports snapshots that no step takes, and buildings that have no nodes to be seen.
    void check_images(const std::vector<Expectation>& expectations) const;

private:
    EventSubjects subjects_;
    std::vector<std::string> snapshots_;
    std::vector<std::string> visible_buildings_;
    std::vector<scene::Diagnostic>& diagnostics_;
};

}  // namespace campuswalk::engine
