#include "engine/script/route.h"

#include <algorithm>

namespace campuswalk::engine {

Tick Route::ticks() const {
    Tick sum = 0;
    for (const RoutePiece& piece : pieces) {
        sum += piece.ticks;
    }
    return sum;
}

double Route::length() const {
    double sum = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        sum += (path[i] - path[i - 1]).norm();
    }
    return sum;
}

double Route::climb() const {
    double sum = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        sum += std::max(0.0, path[i].y() - path[i - 1].y());
    }
    return sum;
}

}  // namespace campuswalk::engine
