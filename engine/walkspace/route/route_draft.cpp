#include "engine/walkspace/route/route_draft.h"

#include <algorithm>
#include <utility>

namespace campuswalk::engine {

using collision::Vec3;

RouteDraft::RouteDraft(const collision::World& world, const RouteSettings& settings,
                       const collision::MoverState& from)
    : world_(world),
      settings_(settings),
      strider_(world, settings.strides, settings.solids),
      trial_(world, settings.strides, settings.solids, settings.keep_out),
      state_(from) {
    route_.path.push_back(state_.foot);
}

std::optional<WalkedPiece> RouteDraft::walk(RoutePiece piece, Tick most, bool may_touch) {
    const auto end = trial_.walk(state_, piece, most, may_touch);
    if (!end) {
        return std::nullopt;
    }
    return WalkedPiece{std::move(piece), *end, trial_.path(), tight_ticks(trial_.path())};
}

void RouteDraft::append(const WalkedPiece& walked) {
    route_.pieces.push_back(walked.piece);
    route_.path.insert(route_.path.end(), walked.path.begin(), walked.path.end());
    state_ = walked.end.state;
}

bool RouteDraft::append_stride(RoutePiece piece) {
    const auto end = trial_.stride(state_, piece);
    if (end) {
        append({std::move(piece), *end, trial_.path()});
    }
    return end.has_value();
}

void RouteDraft::go_back_to(const Mark& mark) {
    state_ = mark.state;
    route_.pieces.resize(mark.pieces);
    route_.path.resize(mark.points);
}

Tick RouteDraft::ticks_since(const Mark& mark) const {
    const std::vector<Vec3> path(route_.path.begin() + static_cast<std::ptrdiff_t>(mark.points),
                                 route_.path.end());
    return static_cast<Tick>(path.size()) + (kTightFactor - 1) * tight_ticks(path);
}

Tick RouteDraft::tight_ticks(const std::vector<Vec3>& path) const {
    return settings_.is_tight ? static_cast<Tick>(std::ranges::count_if(path, settings_.is_tight)) : 0;
}

}  // namespace campuswalk::engine
