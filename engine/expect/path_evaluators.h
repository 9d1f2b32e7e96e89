#pragma once

#include <optional>
#include <string>

#include "engine/expect/finding.h"
#include "engine/record/tick_record.h"

namespace campuswalk::engine {

// Judges of where the avatar went; see event_evaluators.h.

class ReachesJudge {
public:
    explicit ReachesJudge(const ExpectReaches& expected) : expected_(&expected) {}
    void see(const FrameRecord& record, const Moment& now);
    Finding finding(bool ended) const;

private:
    const ExpectReaches* expected_;
    double nearest_ = 1e300;  ///< metres
    Moment when_;
};

class NearJudge {
public:
    explicit NearJudge(const ExpectNear& expected) : expected_(&expected) {}
    void see(const FrameRecord& record, const Moment& now);
    Finding finding(bool ended) const;

private:
    struct Place {
        double distance = 0.0;  ///< metres, from the target
        std::string when;       ///< as it would be told
        Moment moment;
    };
    std::string told_place(const Place& place) const;

    const ExpectNear* expected_;
    std::optional<Place> last_;   ///< the end of the last tick, or the last event's
    std::optional<Place> first_;  ///< too far away: the first event's
};

class DurationJudge {
public:
    explicit DurationJudge(const ExpectDuration& expected) : expected_(&expected) {}
    void see(const FrameRecord& record, const Moment& /*now*/) { time_ = record.time; }
    Finding finding(bool ended) const;

private:
    const ExpectDuration* expected_;
    double time_ = 0.0;
};

class DistanceJudge {
public:
    explicit DistanceJudge(const ExpectDistance& expected) : expected_(&expected) {}
    void see(const FrameRecord& record, const Moment& /*now*/) { distance_ = record.distance; }
    Finding finding(bool ended) const;

private:
    const ExpectDistance* expected_;
    double distance_ = 0.0;
};

}  // namespace campuswalk::engine
