#pragma once

#include "engine/record/tick_record.h"

namespace campuswalk::engine {

/// Reads a walk while it is simulated. The simulation doesn't depend on observers, and they can't change a
/// walk. A failure to write (disk full, no GL) is thrown as std::runtime_error and ends the program with exit
/// code 3.
class Observer {
public:
    virtual ~Observer() = default;

    /// Once before the first tick.
    virtual void begin(const Walk& walk) { static_cast<void>(walk); }
    /// After every tick, and once more with the closing events of the walk.
    virtual void on_tick(const TickRecord& record) = 0;
    /// Once after the last record; everything must be on disk when this returns.
    virtual void end() {}
};

}  // namespace campuswalk::engine
