#pragma once

#include "engine/observers/line_sink.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// The avatar at the end of every tick, for spreadsheets and plots: a header, then one line
/// `t,x,y,z,yaw_deg,pitch_deg,grounded,height` per tick. Seconds, metres and degrees; the body's foot point;
/// its height is less than the profile's while it crouches. Nine decimals: a nanometre, without the noise
/// after it.
class TrajectoryCsv final : public Observer {
public:
    explicit TrajectoryCsv(LineSink sink) : sink_(std::move(sink)) {}

    void begin(const Walk& walk) override;
    void on_tick(const TickRecord& record) override;

private:
    LineSink sink_;
    double height_ = 0.0;
    Tick next_ = 0;
};

/// The same for tools that compare trajectories (the TUM format): one line `t tx ty tz qx qy qz qw` per tick.
/// The pose of a frame at the foot point that turns with the eyes, x right, y up, -z ahead; qw is never
/// negative.
class TrajectoryTum final : public Observer {
public:
    explicit TrajectoryTum(LineSink sink) : sink_(std::move(sink)) {}

    void begin(const Walk&) override { next_ = 0; }
    void on_tick(const TickRecord& record) override;

private:
    LineSink sink_;
    Tick next_ = 0;
};

}  // namespace campuswalk::engine
