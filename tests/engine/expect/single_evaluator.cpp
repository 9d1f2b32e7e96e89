#include "tests/engine/expect/single_evaluator.h"

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {

namespace {

const scene::Campus& nowhere() {
    static const scene::Campus campus = empty_campus();
    return campus;
}

}  // namespace

SingleEvaluator::SingleEvaluator(Expectation expected) : SingleEvaluator(std::move(expected), nowhere()) {}

SingleEvaluator::SingleEvaluator(Expectation expected, const scene::Campus& campus)
    : expected_(std::move(expected)), evaluator_(Evaluator::of(expected_, campus, avatar_)) {}

void SingleEvaluator::on_tick(const TickRecord& record) {
    history_.on_tick(record);
    evaluator_->on_tick(record, history_.now());
}

Event made_event(const std::string& words, std::vector<Field> fields) {
    const EventPattern made = pattern(words);
    const std::vector<EventKind> kinds = event_kinds();
    const auto kind = std::ranges::find_if(kinds, [&](EventKind each) { return name_of(each) == made.kind; });
    return {0, 1.0, *kind, made.object, std::move(fields)};
}

TickFeed& TickFeed::tick(const std::vector<std::string>& event_lines, const Eigen::Vector3d& position) {
    std::vector<Event> events;
    events.reserve(event_lines.size());
    for (const std::string& words : event_lines) {
        events.push_back(made_event(words));
    }
    return with(std::move(events), position);
}

TickFeed& TickFeed::with(std::vector<Event> events, const Eigen::Vector3d& position) {
    for (Event& event : events) {
        event.tick = tick_;
    }
    TickRecord record;
    record.tick = tick_;
    record.time = static_cast<double>(tick_) / 10.0;
    record.avatar.position = position;
    record.avatar.grounded = grounded_;
    record.distance = distance_;
    record.events = events;
    on_tick_(record);
    ++tick_;
    return *this;
}

TickFeed& TickFeed::in_the_air(bool airborne) {
    grounded_ = !airborne;
    return *this;
}

TickFeed& TickFeed::after_metres(double distance) {
    distance_ = distance;
    return *this;
}

void expect_failure(const std::optional<Failure>& failure, int mark_line, const std::string& code,
                    const std::vector<std::string>& facts) {
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->mark.line, mark_line);
    EXPECT_EQ(failure->code, code);
    for (const std::string& fact : facts) {
        EXPECT_THAT(failure->message, testing::HasSubstr(fact));
    }
}

}  // namespace campuswalk::engine
