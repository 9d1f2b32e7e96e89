#include "engine/observers/trajectory.h"

#include <string>

#include "collision/geometry/trigonometry.h"
#include "engine/events/decimals.h"

namespace campuswalk::engine {

namespace {

constexpr int kDigits = 9;

std::string number(double value) {
    return fixed(value, kDigits);
}

/// A walk's closing record repeats its last tick.
bool is_new(const TickRecord& record, Tick& next) {
    if (record.tick < next) {
        return false;
    }
    next = record.tick + 1;
    return true;
}

}  // namespace

void TrajectoryCsv::begin(const Walk& walk) {
    height_ = walk.avatar.height;
    next_ = 0;
    sink_("t,x,y,z,yaw_deg,pitch_deg,grounded,height");
}

void TrajectoryCsv::on_tick(const TickRecord& record) {
    if (!is_new(record, next_)) {
        return;
    }
    const AvatarState& avatar = record.avatar;
    std::string line = number(record.time);
    for (const double value : {avatar.position.x(), avatar.position.y(), avatar.position.z(),
                               degrees(avatar.yaw), degrees(avatar.pitch)}) {
        line += "," + number(value);
    }
    sink_(line + (avatar.grounded ? ",1," : ",0,") + number(avatar.stature * height_));
}

void TrajectoryTum::on_tick(const TickRecord& record) {
    if (!is_new(record, next_)) {
        return;
    }
    // Yaw about +Y, then pitch about the turned x axis.
    const AvatarState& avatar = record.avatar;
    const collision::SinCos yaw = collision::sin_cos(0.5 * avatar.yaw);
    const collision::SinCos pitch = collision::sin_cos(0.5 * avatar.pitch);
    const double qw = yaw.cos * pitch.cos;
    const double sign = qw < 0.0 ? -1.0 : 1.0;
    std::string line = number(record.time);
    for (const double value :
         {avatar.position.x(), avatar.position.y(), avatar.position.z(), sign * yaw.cos * pitch.sin,
          sign * yaw.sin * pitch.cos, -sign * yaw.sin * pitch.sin, sign * qw}) {
        line += " " + number(value);
    }
    sink_(line);
}

}  // namespace campuswalk::engine
