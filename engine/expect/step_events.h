#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/script/mentions.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Numbers from `least` to `most`.
struct Interval {
    double least = 0.0;
    double most = 0.0;
};

/// The events that only a walk's own steps cause, from walk.start to walk.end. Whether the visitor gets where
/// a step leads to isn't certain; what the step itself does is, in a walk that nothing stops.
class StepEvents {
public:
    StepEvents(const scene::Campus& campus, const Walk& walk);

    /// Whether events of this kind come from steps only.
    static bool is_caused_by_steps(EventKind kind);

    /// How often events that match come from the first `steps` steps. walk.end comes from one after the last.
    Interval times(const EventPattern& event, std::size_t steps) const;
    /// Whether events that match can come in this order. `at_any_time[i]`: the campus can cause the i-th,
    /// too.
    bool can_come(const std::vector<EventPattern>& in_order, const std::vector<bool>& at_any_time,
                  std::size_t steps) const;
    /// Whether events that match come for certain and in this order.
    bool are_certain(const std::vector<EventPattern>& in_order, std::size_t steps) const;

private:
    struct StepEvent {
        std::size_t step = 0;
        EventKind kind = EventKind::walk_start;
        std::string object;
        bool certain = false;
    };

    static bool matches(const EventPattern& pattern, const StepEvent& event);
    void add(std::size_t index, const Step& step, const Walk& walk);
    void add_switched(std::size_t index, const StepPreview::Switch& step, const scene::Campus& campus,
                      const Walk& walk, std::vector<bool>& disabled);

    std::vector<StepEvent> events_;  ///< in the order in which the steps cause them
};

}  // namespace campuswalk::engine
