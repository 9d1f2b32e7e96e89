#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/event_pattern.h"
#include "engine/expect/failure.h"
#include "engine/frame_record.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

// One judge an expectation: sees every frame, then says what is wrong, if anything. The expectation must
// outlive it.

class SequenceJudge {
public:
    explicit SequenceJudge(const ExpectSequence& expected)
        : expected_(expected), early_(expected.events.size()) {}
    void see(const FrameRecord& record);
    std::optional<Failure> verdict() const;

private:
    const ExpectSequence& expected_;
    std::size_t met_ = 0;             ///< how many of the events have come
    std::string last_event_;          ///< of those, as it would be told
    std::vector<std::string> early_;  ///< for each, the last event like it that came before its turn
};

class NeverJudge {
public:
    explicit NeverJudge(const ExpectNever& expected) : expected_(expected) {}
    void see(const FrameRecord& record);
    std::optional<Failure> verdict() const;

private:
    const ExpectNever& expected_;
    int times_ = 0;
    std::string first_event_;
};

class CountJudge {
public:
    explicit CountJudge(const ExpectCount& expected) : expected_(expected) {}
    void see(const FrameRecord& record);
    std::optional<Failure> verdict() const;

private:
    const ExpectCount& expected_;
    int times_ = 0;
};

class ReachesJudge {
public:
    explicit ReachesJudge(const ExpectReaches& expected) : expected_(expected) {}
    void see(const FrameRecord& record);
    std::optional<Failure> verdict() const;

private:
    const ExpectReaches& expected_;
    double nearest_ = 1e300;  ///< metres
    double nearest_time_ = 0.0;
};

using Judge = std::variant<SequenceJudge, NeverJudge, CountJudge, ReachesJudge>;

/// All expectations of a walk, held against its frames.
class Jury {
public:
    /// `walk` must outlive it.
    explicit Jury(const Walk& walk);
    void see(const FrameRecord& record);
    /// In the order of the file; empty when everything was as expected.
    std::vector<Failure> verdicts() const;

private:
    std::vector<Judge> judges_;
};

}  // namespace campuswalk::engine
