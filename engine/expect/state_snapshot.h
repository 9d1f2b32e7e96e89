#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "engine/record/tick_record.h"

namespace campuswalk::engine {

/// An event with its time in the logs.
struct TimedEvent {
    Event event;
    double time = 0.0;  ///< seconds
};

/// The state of a walk at the end of a tick. Cheap to copy, so that an evaluator can store the decisive one.
struct StateSnapshot {
    static constexpr std::size_t kEvents = 5;

    Tick tick = 0;
    double time = 0.0;  ///< seconds
    AvatarState avatar;
    double distance = 0.0;                ///< metres so far
    std::optional<std::size_t> building;  ///< of the window that opened last, of those that are open
    /// The last events, the oldest first; null if there were fewer.
    std::array<std::shared_ptr<const TimedEvent>, kEvents> events;
    std::shared_ptr<const TimedEvent> obstacle;         ///< the last of being blocked or stuck; null: none
    std::shared_ptr<const std::vector<bool>> disabled;  ///< by object; null: none is
};

/// Follows a walk from record to record.
class StateHistory {
public:
    void on_tick(const TickRecord& record);
    const StateSnapshot& now() const { return now_; }

private:
    void keep(const Event& event, double time);

    StateSnapshot now_;
};

}  // namespace campuswalk::engine
