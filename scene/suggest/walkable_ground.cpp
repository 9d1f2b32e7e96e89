#include "scene/suggest/walkable_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include <Eigen/Geometry>

#include "collision/mesh/mesh_query.h"
#include "collision/world/placement.h"

namespace campuswalk::scene {

using collision::Aabb;
using collision::MeshCollider;
using collision::Vec3;

namespace {

constexpr double kCell = 0.5;               // metres
constexpr double kMaxExtent = 150.0;        // metres
constexpr double kRadius = 0.3;             // metres, of the default avatar
constexpr double kHeight = 1.8;             // metres
constexpr double kHeadroom = 1.95;          // metres
constexpr double kStep = 0.3;               // metres
constexpr double kSteepest = 0.77;          // cosine: 40 degrees
constexpr double kSearch = 0.05;            // metres: the round foot of a capsule stands higher on a slope
constexpr double kBoxDistance = 0.5;        // metres from a box
constexpr std::uint32_t kEnoughCells = 16;  // cells from an edge

const collision::QueryFilter kSolid;

}  // namespace

WalkableGround::WalkableGround(const std::shared_ptr<const MeshCollider>& mesh, const Vec3& p_world_origin,
                               const Vec3& center)
    : world_(std::make_unique<collision::LinearBroadPhase>()) {
    collision::Object object;
    object.shape = mesh;
    object.X_world_shape.translation = p_world_origin;
    world_.add(object);
    const Aabb& bounds = world_.bounds();
    const Vec3 half = Vec3::Constant(0.5 * kMaxExtent);
    const Vec3 low = bounds.min.cwiseMax(center - half);
    const Vec3 high = bounds.max.cwiseMin(center + half);
    origin_ = Vec3(low.x(), 0.0, low.z()) + Vec3(0.5 * kCell, 0.0, 0.5 * kCell);
    width_ = std::max<std::int64_t>(static_cast<std::int64_t>((high.x() - low.x()) / kCell), 0);
    depth_ = std::max<std::int64_t>(static_cast<std::int64_t>((high.z() - low.z()) / kCell), 0);
    columns_.resize(static_cast<std::size_t>(width_ * depth_));
    find_floors(*mesh, p_world_origin, kSearch);
    if (spots_.empty()) {  // perhaps stairs without landings
        find_floors(*mesh, p_world_origin, kStep);
    }
    connect();
    label_components();
    measure_edge_distances();
}

void WalkableGround::find_floors(const MeshCollider& mesh, const Vec3& p_world_origin, double search) {
    std::vector<collision::MeshHit> hits;
    const double top = world_.bounds().max.y() + 1.0;
    const double bottom = world_.bounds().min.y() - 1.0;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const auto number = static_cast<std::int64_t>(c);
        const std::int64_t row = number / width_;
        const std::int64_t column = number % width_;
        Vec3 from = origin_ + kCell * Vec3(static_cast<double>(column), 0.0, static_cast<double>(row));
        from.y() = top;
        Vec3 to = from;
        to.y() = bottom;
        all_on_ray(mesh, {from - p_world_origin, to - p_world_origin}, hits);
        double above = std::numeric_limits<double>::infinity();
        for (const collision::MeshHit& hit : hits) {  // from the top down
            const Vec3 foot = from + hit.fraction * (to - from);
            const collision::Triangle t = vertices(mesh.mesh(), hit.triangle);
            const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
            const bool flat = std::abs(normal.y()) >= kSteepest * normal.norm();
            if (flat && above - foot.y() >= kHeadroom) {
                const auto free = free_place(world_, kSolid, foot, kRadius, kHeight, search);
                if (free) {
                    columns_[c].spots.push_back(static_cast<std::uint32_t>(spots_.size()));
                    Spot& spot = spots_.emplace_back();
                    spot.foot = foot;
                    spot.open_sky = std::isinf(above);
                }
            }
            above = foot.y();
        }
        for (std::size_t s = 0; s + 1 < columns_[c].spots.size(); ++s) {
            spots_[columns_[c].spots[s]].upstairs = true;
        }
    }
}

bool WalkableGround::connect(std::uint32_t a, const Column& column) {
    bool connected = false;
    for (const std::uint32_t b : column.spots) {
        const Vec3& from = spots_[a].foot;
        const Vec3& to = spots_[b].foot;
        if (std::abs(from.y() - to.y()) > kStep) {
            continue;
        }
        Vec3 between = 0.5 * (from + to);
        between.y() = std::min(from.y(), to.y());
        if (free_place(world_, kSolid, between, kRadius, kHeight, kStep + kSearch)) {
            spots_[a].next.push_back(b);
            spots_[b].next.push_back(a);
            connected = true;
        }
    }
    return connected;
}

void WalkableGround::connect() {
    for (std::int64_t z = 0; z < depth_; ++z) {
        for (std::int64_t x = 0; x < width_; ++x) {
            for (const std::uint32_t spot : column_at(x, z).spots) {
                // An avatar doesn't fit right before a step: the adjacent cell may have no spot.
                const bool right = x + 1 < width_ && connect(spot, column_at(x + 1, z));
                if (!right && x + 2 < width_) {
                    connect(spot, column_at(x + 2, z));
                }
                const bool back = z + 1 < depth_ && connect(spot, column_at(x, z + 1));
                if (!back && z + 2 < depth_) {
                    connect(spot, column_at(x, z + 2));
                }
            }
        }
    }
}

void WalkableGround::label_components() {
    std::vector<std::uint32_t> open;
    std::uint32_t component = 0;
    for (std::uint32_t first = 0; first < spots_.size(); ++first) {
        if (spots_[first].component != 0) {
            continue;
        }
        spots_[first].component = ++component;
        open = {first};
        while (!open.empty()) {
            const std::uint32_t spot = open.back();
            open.pop_back();
            for (const std::uint32_t next : spots_[spot].next) {
                if (spots_[next].component == 0) {
                    spots_[next].component = component;
                    open.push_back(next);
                }
            }
        }
    }
}

void WalkableGround::measure_edge_distances() {
    constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();
    std::queue<std::uint32_t> open;
    for (std::uint32_t s = 0; s < spots_.size(); ++s) {
        spots_[s].edge_distance = spots_[s].next.size() < 4 ? 0 : kUnknown;
        if (spots_[s].edge_distance == 0) {
            open.push(s);
        }
    }
    for (; !open.empty(); open.pop()) {
        for (const std::uint32_t next : spots_[open.front()].next) {
            if (spots_[next].edge_distance == kUnknown) {
                spots_[next].edge_distance = spots_[open.front()].edge_distance + 1;
                open.push(next);
            }
        }
    }
}

std::optional<std::uint32_t> WalkableGround::best_spawn_spot(const Vec3& center,
                                                             const std::vector<UprightBox>& boxes) const {
    std::vector<std::size_t> weight(spots_.size() + 1);
    for (const Spot& spot : spots_) {
        weight[spot.component] += spot.upstairs ? 1 : spot.open_sky ? 8 : 2;
    }
    const auto component =
        static_cast<std::uint32_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
    // Compared lexicographically.
    using Score = std::tuple<bool, bool, bool, std::uint32_t, double>;
    const auto score_of = [&](const Spot& spot) {
        const bool outside = std::ranges::none_of(
            boxes, [&](const UprightBox& box) { return box.depth_of(spot.foot) > -kBoxDistance; });
        return Score(!spot.upstairs, spot.open_sky, outside, std::min(spot.edge_distance, kEnoughCells),
                     -(spot.foot - center).squaredNorm());
    };
    std::optional<std::uint32_t> best;
    Score best_score;
    for (std::uint32_t s = 0; s < spots_.size(); ++s) {
        if (spots_[s].component != component) {
            continue;
        }
        const Score score = score_of(spots_[s]);
        if (!best || score > best_score) {
            best = s;
            best_score = score;
        }
    }
    return best;
}

std::size_t WalkableGround::count_reachable(std::uint32_t spot) const {
    return static_cast<std::size_t>(std::ranges::count(spots_, spots_[spot].component, &Spot::component));
}

std::vector<std::uint32_t> WalkableGround::shortest_paths_from(std::uint32_t start) const {
    std::vector<std::uint32_t> predecessors(spots_.size());
    std::vector<std::uint32_t> cost(spots_.size(), std::numeric_limits<std::uint32_t>::max());
    for (std::uint32_t s = 0; s < predecessors.size(); ++s) {
        predecessors[s] = s;
    }
    using Entry = std::pair<std::uint32_t, std::uint32_t>;  // cost, spot: ties go to the lower index
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    cost[start] = 0;
    open.emplace(0, start);
    while (!open.empty()) {
        const auto [so_far, spot] = open.top();
        open.pop();
        if (so_far > cost[spot]) {
            continue;
        }
        for (const std::uint32_t next : spots_[spot].next) {
            constexpr std::uint32_t kEdgeCost = 8;
            const std::uint32_t there = so_far + (spots_[next].edge_distance > 0 ? 1 : kEdgeCost);
            if (there < cost[next]) {
                cost[next] = there;
                predecessors[next] = spot;
                open.emplace(there, next);
            }
        }
    }
    return predecessors;
}

bool WalkableGround::is_straight(const Vec3& from, const Vec3& to) const {
    const auto steps = static_cast<int>(std::ceil((to - from).norm() / (0.5 * kCell)));
    double y = from.y();
    for (int i = 1; i <= steps; ++i) {
        const Vec3 p = from + (to - from) * (static_cast<double>(i) / steps);
        const Column& column = column_at(std::llround((p.x() - origin_.x()) / kCell),
                                         std::llround((p.z() - origin_.z()) / kCell));
        const auto on = std::find_if(column.spots.begin(), column.spots.end(), [&](std::uint32_t s) {
            return std::abs(spots_[s].foot.y() - y) <= kStep && (spots_[s].edge_distance > 0 || i == steps);
        });
        if (on == column.spots.end()) {
            return false;
        }
        y = spots_[*on].foot.y();
    }
    return std::abs(y - to.y()) < kStep;
}

std::vector<Vec3> WalkableGround::waypoints(const std::vector<std::uint32_t>& predecessors,
                                            std::uint32_t end) const {
    std::vector<Vec3> path = {spots_[end].foot};
    for (std::uint32_t s = end; predecessors[s] != s; s = predecessors[s]) {
        path.push_back(spots_[predecessors[s]].foot);
    }
    std::reverse(path.begin(), path.end());
    std::vector<Vec3> simplified = {path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
        const bool last = i + 1 == path.size();
        if (last || !is_straight(simplified.back(), path[i + 1])) {
            simplified.push_back(path[i]);
        }
    }
    return simplified;
}

}  // namespace campuswalk::scene
