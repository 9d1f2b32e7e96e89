#pragma once

#include <functional>
#include <string>

#include "engine/observers/line_sink.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// The cost of every tick, in the format of Chrome's trace viewer and Perfetto: one slice per tick, in it one
/// for moving and one for detecting contacts, and the walk's events as marks. A slice lasts one microsecond
/// for each sphere, box and triangle test in it, so that the same walk produces the same bytes; a tick is one
/// longer than its stages. `otherData` has the terms of the paper's eq. (4), T = Nv Cv + Np Cp + Nu Cu, for
/// the whole walk.
class CostTrace final : public Observer {
public:
    /// Microseconds of wall time since some point in time.
    using Clock = std::function<double()>;

    /// With a clock, a second track shows the wall time of each tick, which differs from run to run.
    explicit CostTrace(LineSink sink, Clock clock = {}) : sink_(std::move(sink)), clock_(std::move(clock)) {}

    void begin(const Walk& walk) override;
    void on_tick(const TickRecord& record) override;
    void end() override;

private:
    void slice(const std::string& name, int track, double start, double duration, const std::string& details);
    double stage(const char* name, double start, const collision::QueryStatistics& cost);

    LineSink sink_;
    Clock clock_;
    collision::QueryStatistics total_;
    bool hybrid_ = false;  ///< the kind of trees that the walk's campus has
    double cost_so_far_ = 0.0;
    double began_ = 0.0;  // by the clock
    double last_ = 0.0;
    Tick next_ = 0;
};

}  // namespace campuswalk::engine
