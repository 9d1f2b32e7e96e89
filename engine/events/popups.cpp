#include "engine/events/popups.h"

#include <algorithm>

namespace campuswalk::engine {

bool Popups::enter(std::size_t building, std::size_t contact, Tick tick, const PopupTiming& timing) {
    ++buildings_[building].contacts;
    if (timing.dwell > 0) {
        dwelling_.push_back({building, contact, tick + timing.dwell, timing});
        return false;
    }
    return try_open(building, tick, timing);
}

bool Popups::leave(std::size_t building, std::size_t contact, Tick tick) {
    std::erase_if(dwelling_, [&](const Dwelling& one) { return one.contact == contact; });
    if (--buildings_[building].contacts > 0 || !is_open(building)) {
        return false;
    }
    std::erase(open_, building);
    buildings_[building].closed = tick;
    return true;
}

std::vector<std::size_t> Popups::open_due(Tick tick) {
    std::vector<std::size_t> opened;
    for (const Dwelling& one : dwelling_) {
        if (one.due <= tick && try_open(one.building, tick, one.timing)) {
            opened.push_back(one.building);
        }
    }
    std::erase_if(dwelling_, [&](const Dwelling& one) { return one.due <= tick; });
    return opened;
}

bool Popups::try_open(std::size_t building, Tick tick, const PopupTiming& timing) {
    Building& record = buildings_[building];
    const bool too_soon = record.closed && tick - *record.closed < timing.cooldown;
    if (is_open(building) || too_soon || (timing.once && record.visits > 0)) {
        return false;
    }
    open_.push_back(building);
    ++record.visits;
    return true;
}

bool Popups::is_open(std::size_t building) const {
    return std::ranges::find(open_, building) != open_.end();
}

}  // namespace campuswalk::engine
