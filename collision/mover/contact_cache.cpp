#include "collision/mover/contact_cache.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "collision/mesh/mesh_query.h"
#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// How far beyond the requested box pieces are gathered horizontally, metres. The margin grows where there
/// are few pieces: they are quick to gather and survey, and a walker then rarely needs others.
constexpr double kMinMargin = 0.2;
constexpr double kMaxMargin = 2.0;
constexpr std::size_t kFewPieces = 16;
constexpr std::size_t kManyPieces = 40;
/// The vertical margin, metres.
constexpr double kVerticalMargin = 0.2;

/// Pieces that memory is reserved for at first.
constexpr std::size_t kInitialCapacity = 128;

/// Never 0, which marks a free slot.
std::uint64_t key_of(ObjectId id, std::uint32_t triangle) {
    return (static_cast<std::uint64_t>(index_of(id)) + 1) << 32U | triangle;
}

/// `slots` is a power of two.
std::size_t slot_of(std::uint64_t key, std::size_t slots) {
    return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> 32U) & (slots - 1);
}

Aabb bounds_of(const Triangle& t) {
    return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

bool contains(const Aabb& outer, const Aabb& inner) {
    return (outer.min.array() <= inner.min.array()).all() && (inner.max.array() <= outer.max.array()).all();
}

}  // namespace

bool ContactCache::is_for(const World& world, const MoverSettings& settings,
                          const QueryFilter& filter) const {
    return world_ == &world && settings_ == settings && filter_ == filter;
}

void ContactCache::prepare(const World& world, const MoverSettings& settings, const QueryFilter& filter) {
    clear();
    world_ = &world;
    settings_ = settings;
    filter_ = filter;
}

void ContactCache::clear() {
    covered_ = Aabb{};
    margin_ = kFirstMargin;
    pieces_.clear();
    measured_.clear();
    unused_.resize(measurements_.size());
    std::iota(unused_.begin(), unused_.end(), 0U);
}

void ContactCache::cover(const Aabb& box, double below, QueryStatistics* statistics) {
    if (!contains(covered_, box)) {
        const Vec3 more(margin_, kVerticalMargin, margin_);
        move_to({box.min - more - Vec3(0, below, 0), box.max + more}, statistics);
    }
}

void ContactCache::move_to(const Aabb& box, QueryStatistics* statistics) {
    const Aabb before = covered_;
    covered_ = box;
    drop_outside();
    gather(before, statistics);
    restart_bounds();
    if (pieces_.size() < kFewPieces) {
        margin_ = std::min(kMaxMargin, 1.4 * margin_);
    } else if (pieces_.size() > kManyPieces) {
        margin_ = std::max(kMinMargin, 0.5 * margin_);
    }
}

void ContactCache::drop_outside() {
    for (std::size_t i = 0; i < pieces_.size();) {
        if (pieces_[i].box.overlaps(covered_)) {
            ++i;
            continue;
        }
        if (measured_[i] != kNotMeasured) {
            unused_.push_back(measured_[i]);
        }
        pieces_[i] = pieces_.back();
        measured_[i] = measured_.back();
        pieces_.pop_back();
        measured_.pop_back();
    }
}

/// Adds the pieces of an object's shape.
struct ContactCache::PieceGatherer {
    ContactCache& cache;
    ObjectId id;
    const Aabb& before;
    QueryStatistics* statistics;

    void operator()(const std::shared_ptr<const MeshCollider>& mesh) const {
        const Pose& X = cache.world_->object(id).X_world_shape;
        const auto take = [&](std::uint32_t t, const Triangle& c) {
            if (!cache.has_piece(id, t)) {
                cache.add_triangle(id, t, {X * c.a, X * c.b, X * c.c});
            }
        };
        visit_triangles_beyond(*mesh, X, before, cache.covered_, take, statistics);
    }
    void operator()(const Box& box) const { cache.gather_box(id, box); }
    void operator()(const Sphere&) const { cache.gather_round(id); }
    void operator()(const Capsule&) const { cache.gather_round(id); }
    void operator()(const Wheel&) const { cache.gather_round(id); }
};

void ContactCache::gather(const Aabb& before, QueryStatistics* statistics) {
    rebuild_keys();
    world_->candidates(covered_, filter_, candidates_);
    for (const ObjectId id : candidates_) {
        std::visit(PieceGatherer{*this, id, before, statistics}, world_->object(id).shape);
    }
}

/// A round solid is one piece.
void ContactCache::gather_round(ObjectId id) {
    if (!has_piece(id, 0)) {
        add(solid_obstacle(*world_, id), world_->bounds(id));
    }
}

/// Open addressing, at most a quarter full.
void ContactCache::rebuild_keys() {
    keys_.assign(std::bit_ceil(std::max(kInitialCapacity, pieces_.size()) * 4), 0);
    for (const Piece& piece : pieces_) {
        const std::uint64_t key = key_of(piece.obstacle.object, piece.obstacle.triangle);
        std::size_t at = slot_of(key, keys_.size());
        while (keys_[at] != 0) {
            at = (at + 1) & (keys_.size() - 1);
        }
        keys_[at] = key;
    }
}

/// As of the last `rebuild_keys`.
bool ContactCache::has_piece(ObjectId id, std::uint32_t triangle) const {
    const std::uint64_t key = key_of(id, triangle);
    std::size_t at = slot_of(key, keys_.size());
    while (keys_[at] != 0 && keys_[at] != key) {
        at = (at + 1) & (keys_.size() - 1);
    }
    return keys_[at] == key;
}

/// As its twelve triangles, through which no body gets in.
void ContactCache::gather_box(ObjectId id, const Box& box) {
    const Pose& X = world_->object(id).X_world_shape;
    const auto vertex = [&](unsigned i) {
        const Vec3 side((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
        return Vec3(X * side.cwiseProduct(box.half_extents));
    };
    constexpr std::array<std::array<unsigned, 4>, 6> kFaces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    const auto add_face = [&](std::uint32_t index, unsigned a, unsigned b, unsigned c) {
        if (!has_piece(id, index)) {
            add_triangle(id, index, {vertex(a), vertex(b), vertex(c)});
        }
    };
    std::uint32_t index = 0;
    for (const auto& f : kFaces) {
        add_face(index++, f[0], f[1], f[2]);
        add_face(index++, f[0], f[2], f[3]);
    }
}

void ContactCache::add_triangle(ObjectId id, std::uint32_t index, const Triangle& vertices) {
    if (const Aabb box = bounds_of(vertices); box.overlaps(covered_)) {
        add(triangle_obstacle(id, index, vertices), box);
    }
}

void ContactCache::add(const Obstacle& obstacle, const Aabb& box) {
    const bool walkable = obstacle.solid == nullptr && std::abs(obstacle.normal.y()) >= settings_.min_up;
    reserve_for(pieces_.size() + 1);
    pieces_.push_back({obstacle, box, walkable});
    measured_.push_back(kNotMeasured);
}

/// About the new centre. A piece's latest measurement gives a better bound than its box.
void ContactCache::restart_bounds() {
    origin_ = covered_.center();
    // Some roundings of float32 at the size of the covered region.
    slack_ = 1e-6 * (1.0 + (covered_.max - covered_.min).norm());
    bounds_.assign((pieces_.size() + kLanes - 1) / kLanes, Bounds{});
    near_.resize(bounds_.size() * kLanes + 1);  // `survey` writes one past the last that it returns
    if (!bounds_.empty()) {
        bounds_.back().offset.fill(std::numeric_limits<float>::infinity());
    }
    for (Index i = 0; i < pieces_.size(); ++i) {
        if (measured_[i] != kNotMeasured) {
            const Measurements& known = measurements_[measured_[i]];
            if (const Separation& s = known.measured[known.last]; s.distance > 0.0) {
                set_bound(i, s.normal, s.bound(origin_));
                continue;
            }
        }
        bound_by_box(i);
    }
}

/// With `push_back` alone, one piece more than ever before would allocate.
void ContactCache::reserve_for(std::size_t count) {
    if (count > pieces_.capacity()) {
        const std::size_t room = std::max(kInitialCapacity, count + count / 2);
        pieces_.reserve(room);
        measured_.reserve(room);
        bounds_.reserve(room / kLanes + 1);
        near_.reserve(room + kLanes + 1);
        add_measurements();
    }
}

/// By the side of the piece's box that is farthest from a body at the origin.
void ContactCache::bound_by_box(Index i) {
    const Aabb& box = pieces_[i].box;
    const Vec3 above = box.min - origin_;
    const Vec3 below = origin_ - box.max;
    const double head = settings_.height - settings_.radius;
    Vec3 normal(-1, 0, 0);
    double best = above.x();
    const auto offer = [&](double gap, const Vec3& n) {
        if (gap > best) {
            best = gap;
            normal = n;
        }
    };
    offer(below.x(), {1, 0, 0});
    offer(above.z(), {0, 0, -1});
    offer(below.z(), {0, 0, 1});
    offer(above.y() - head, {0, -1, 0});
    offer(below.y() + settings_.radius, {0, 1, 0});
    set_bound(i, normal, best);
}

void ContactCache::set_bound(Index i, const Vec3& normal, double at_origin) {
    Bounds& b = bounds_[i / kLanes];
    const std::size_t lane = i % kLanes;
    b.x[lane] = static_cast<float>(normal.x());
    b.y[lane] = static_cast<float>(normal.y());
    b.z[lane] = static_cast<float>(normal.z());
    b.flat[lane] = static_cast<float>(horizontal_norm(normal));
    b.offset[lane] = static_cast<float>(at_origin);
}

std::span<const ContactCache::Index> ContactCache::survey(const Vec3& foot, double sideways, double up,
                                                          double down, double reach) {
    const Vec3 at = foot - origin_;
    const auto x = static_cast<float>(at.x());
    const auto y = static_cast<float>(at.y());
    const auto z = static_cast<float>(at.z());
    const auto aside = static_cast<float>(sideways);
    const auto rise = static_cast<float>(up);
    const auto drop = static_cast<float>(down);
    const auto limit = static_cast<float>(settings_.radius + reach + slack_);
    std::size_t count = 0;
    Index first = 0;
    for (const Bounds& b : bounds_) {
        Lanes least;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float here = b.offset[i] + (b.x[i] * x + b.y[i] * y + b.z[i] * z) - b.flat[i] * aside;
            least[i] = here + std::min(b.y[i] * rise, -b.y[i] * drop);
        }
        for (std::size_t i = 0; i < kLanes; ++i) {
            near_[count] = first + static_cast<Index>(i);
            count += least[i] <= limit ? 1U : 0U;
        }
        first += kLanes;
    }
    return {near_.data(), count};
}

/// Half as many as there may be pieces, as most are never measured; then half more each time, so that warm
/// ticks which measure a few pieces more than ever before allocate nothing.
void ContactCache::add_measurements() {
    const std::size_t count = measurements_.size();
    measurements_.resize(std::max(pieces_.capacity() / 2, count + count / 2 + 1));
    unused_.reserve(measurements_.size());
    for (std::size_t i = count; i < measurements_.size(); ++i) {
        unused_.push_back(static_cast<std::uint32_t>(i));
    }
}

ContactCache::Measurements& ContactCache::measurements_of(Index i) {
    if (measured_[i] == kNotMeasured) {
        if (unused_.empty()) {
            add_measurements();
        }
        measured_[i] = unused_.back();
        unused_.pop_back();
        measurements_[measured_[i]] = {};
    }
    return measurements_[measured_[i]];
}

Separation& ContactCache::measure(Index i, const Vec3& foot) {
    Measurements& cached = measurements_of(i);
    for (std::uint8_t k = 0; k < 2; ++k) {
        if (cached.measured[k].foot == foot) {
            cached.last = k;
            return cached.measured[k];
        }
    }
    cached.last = cached.last == 0 ? 1 : 0;
    const Obstacle& obstacle = pieces_[i].obstacle;
    const Closest c = closest_upright(settings_.core(foot), obstacle);
    Separation& s = cached.measured[cached.last];
    s.foot = foot;
    s.kind.reset();
    s.distance = c.distance;
    s.on_piece = c.on_shape;
    s.feature = c.feature;
    s.normal = c.distance > 0.0 ? Vec3((c.on_segment - c.on_shape) / c.distance) : obstacle.normal;
    if (c.distance > 0.0) {
        set_bound(i, s.normal, s.bound(origin_));
    }
    return s;
}

/// By what `survey` reads, at `foot` in the covered region.
double ContactCache::bound(Index i, const Vec3& foot) const {
    const Bounds& b = bounds_[i / kLanes];
    const std::size_t lane = i % kLanes;
    const Vec3 normal(b.x[lane], b.y[lane], b.z[lane]);
    return b.offset[lane] + normal.dot(foot - origin_) - slack_;
}

double ContactCache::known_distance(Index i, const Vec3& foot) const {
    const double at_least = std::max(0.0, bound(i, foot));
    if (measured_[i] == kNotMeasured) {
        return at_least;
    }
    const Measurements& known = measurements_[measured_[i]];
    return std::max({at_least, known.measured[0].bound(foot), known.measured[1].bound(foot)});
}

bool ContactCache::known_apart(Index i, const Vec3& from, const Vec3& to, double distance) const {
    const Bounds& b = bounds_[i / kLanes];
    const std::size_t lane = i % kLanes;
    const Vec3 normal(b.x[lane], b.y[lane], b.z[lane]);
    const double least = distance + slack_ - b.offset[lane];
    if (normal.dot(from - origin_) >= least && normal.dot(to - origin_) >= least) {
        return true;  // most pieces, for less than it takes to look up their measurements
    }
    if (measured_[i] == kNotMeasured) {
        return false;
    }
    return std::ranges::any_of(measurements_[measured_[i]].measured, [&](const Separation& s) {
        return s.bound(from) >= distance && s.bound(to) >= distance;  // false for a place that is NaN
    });
}

}  // namespace campuswalk::collision
