#include "engine/events/contact_tracker.h"

#include <algorithm>

namespace campuswalk::engine {

bool ContactTracker::active(collision::ObjectId object) const {
    return std::ranges::binary_search(active_, object, {}, &Contact::object);
}

void ContactTracker::update(Tick tick, const std::vector<ObjectOverlap>& seen, std::vector<Transition>& out) {
    // Merges two lists in ascending order.
    next_.clear();
    auto old = active_.begin();
    const auto drop_before = [&](auto reached) {
        for (; old != active_.end() && !reached(*old); ++old) {
            out.push_back({old->object, Phase::exit, 1.0, tick - old->since});
        }
    };
    for (const ObjectOverlap& s : seen) {
        drop_before([&](const Contact& c) { return c.object >= s.object; });
        if (old != active_.end() && old->object == s.object) {
            const Tick ticks = tick - old->since;
            if (!s.present) {
                out.push_back({s.object, Phase::exit, s.exit_at, ticks});
            } else {
                if (ticks % stay_ticks_ == 0) {
                    out.push_back({s.object, Phase::stay, 1.0, ticks});
                }
                next_.push_back(*old);
            }
            ++old;
        } else if (s.present || (s.touched && s.exit_at > s.enter_at)) {  // grazing for no time is no contact
            out.push_back({s.object, Phase::enter, s.enter_at, 0});
            if (s.present) {
                next_.push_back({s.object, tick});
            } else {
                out.push_back({s.object, Phase::exit, s.exit_at, 0});
            }
        }
    }
    drop_before([](const Contact&) { return false; });
    active_.swap(next_);
}

void ContactTracker::leave_all(Tick tick, std::vector<Transition>& out) {
    for (const Contact& c : active_) {
        out.push_back({c.object, Phase::exit, 1.0, tick - c.since});
    }
    active_.clear();
}

}  // namespace campuswalk::engine
