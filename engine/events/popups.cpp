#include "engine/events/popups.h"

namespace campuswalk::engine {

bool Popups::meet(std::size_t building) {
    if (++met_[building] > 1) {
        return false;
    }
    open_.push_back(building);
    return true;
}

bool Popups::leave(std::size_t building) {
    if (--met_[building] > 0) {
        return false;
    }
    std::erase(open_, building);
    return true;
}

}  // namespace campuswalk::engine
