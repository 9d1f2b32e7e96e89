#include "engine/events/gaze_tracker.h"

#include <algorithm>

namespace campuswalk::engine {

void GazeTracker::advance(Tick tick) {
    std::erase_if(looks_, [&](const Look& look) { return tick - look.last >= hold_; });
}

void GazeTracker::hit(Tick tick, collision::ObjectId object, double distance) {
    const auto place = std::ranges::lower_bound(looks_, object, {}, &Look::object);
    const Look look{object, tick, distance};
    if (place != looks_.end() && place->object == object) {
        *place = look;
    } else {
        looks_.insert(place, look);
    }
}

void GazeTracker::forget(collision::ObjectId object) {
    std::erase_if(looks_, [&](const Look& look) { return look.object == object; });
}

double GazeTracker::distance(collision::ObjectId object) const {
    const auto place = std::ranges::lower_bound(looks_, object, {}, &Look::object);
    return place != looks_.end() && place->object == object ? place->distance : 0.0;
}

}  // namespace campuswalk::engine
