#include "engine/walkspace/barrier/passage_probe.h"

#include <algorithm>
#include <cmath>

#include "engine/walkspace/stride/opposing_contact.h"

namespace campuswalk::engine {

using collision::MoverSettings;
using collision::ObjectId;
using collision::Vec3;

namespace {

/// A local search that has reached this many cells has found no barrier, but another place.
constexpr std::size_t kMostNodes = 4'000;
/// Once the searches for one barrier have reached so many, no other change is tried: what is closed off for
/// good would take minutes.
constexpr std::size_t kMostNodesInAll = 50'000;

}  // namespace

PassageProbe::PassageProbe(const WorkerWorlds& worlds, const ExploreSettings& settings,
                           const PassageQuery& query)
    : worlds_(worlds), settings_(settings), query_(query), disabled_(worlds[0].size(), false) {
    if (settings.solids.disabled != nullptr) {
        disabled_ = *settings.solids.disabled;
    }
    settings_.solids.disabled = &disabled_;
    settings_.starts.clear();
    settings_.within = query.within;
    settings_.known = query.known;
    // The query speaks of these cells.
    settings_.grid = query.known.empty() ? WalkGrid() : query.known.front()->grid;
    settings_.max_nodes = std::min(settings.max_nodes, kMostNodes);
    settings_.max_ticks = static_cast<std::uint32_t>(query.longest_crossing / settings.strides.walk_speed /
                                                     settings.strides.seconds);
    settings_.steer_falls = false;  // by a changed body, that would be no barrier
    settings_.keep_rim = false;
    settings_.progress = {};
}

bool PassageProbe::is_exhausted() const {
    return nodes_in_all_ > kMostNodesInAll;
}

std::optional<FoundPath> PassageProbe::find_path_as_it_is() {
    settings_.steer_falls = query_.steer_falls;
    auto path = find_path(body());
    settings_.steer_falls = false;
    return path;
}

std::optional<FoundPath> PassageProbe::find_path_without(ObjectId object) {
    disabled_[index_of(object)] = true;
    auto path = find_path(body());
    disabled_[index_of(object)] = false;
    return path;
}

std::optional<FoundPath> PassageProbe::find_path_in(const WorkerWorlds& worlds, const MoverSettings& body,
                                                    std::span<const GroundState> from) {
    ExploreSettings settings = settings_;
    settings.strides.body = body;
    settings.more_starts.assign(from.begin(), from.end());
    const WalkSpace space = explore(worlds, settings, UntilCell{query_.is_beyond});
    nodes_in_all_ += space.node_count();
    touched_.clear();
    for (std::size_t i = 0; i < space.touched.size(); ++i) {
        if (space.touched[i]) {
            touched_.push_back(static_cast<ObjectId>(i));
        }
    }
    if (!space.goal) {
        return std::nullopt;
    }
    Strider strider(worlds[0], settings.strides, settings.solids);
    const std::vector<ChainLink> chain = space.chain(*space.goal, strider);
    FoundPath path{chain.front().at, {}, length_of(chain)};
    for (const ChainLink& link : chain) {
        path.feet.push_back(link.at.foot);
    }
    return path;
}

void PassageProbe::locate(const FoundPath& path, Barrier& barrier) const {
    Strider strider(world(), settings_.strides, settings_.solids);
    GroundState at = path.start;
    Vec3 ahead = Vec3::Zero();
    for (std::size_t i = 1; i < path.feet.size(); ++i) {
        const StrideEnd end = strider.walk_to(at, path.feet[i], 0.02, 1.0);
        ahead = path.feet[i] - end.at.foot;
        ahead.y() = 0.0;
        if (end.kind != StrideEnd::Kind::grounded) {
            break;
        }
        at = end.at;
        if (ahead.norm() > 0.05 || std::abs(path.feet[i].y() - at.foot.y()) > body().step_height) {
            break;
        }
    }
    barrier.from = at.foot;
    barrier.at = at.foot;
    if (const auto contact = opposing_contact(world(), settings_.solids, body(), at.foot, ahead)) {
        barrier.object = contact->object;
        barrier.triangle = contact->triangle;
        barrier.at = contact->at;
    }
}

}  // namespace campuswalk::engine
