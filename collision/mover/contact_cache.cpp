#include "collision/mover/contact_cache.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <Eigen/Geometry>

#include "collision/mesh/mesh_query.h"
#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// How much more than what is asked for is gathered to the sides, metres. Where little comes of it, more is
/// gathered the next time: few pieces are soon gathered and surveyed, and a walker then seldom needs others.
constexpr double kLeastMargin = 0.2;
constexpr double kMostMargin = 2.0;
constexpr std::size_t kFewPieces = 16;
constexpr std::size_t kManyPieces = 40;
/// Likewise above and below.
constexpr double kUpright = 0.2;
/// More is gathered when no more than this share of that is left.
constexpr double kSoon = 0.4;

/// Room that is there from the beginning, for so many pieces.
constexpr std::size_t kUsual = 256;

/// Never 0.
std::uint64_t name_of(ObjectId id, std::uint32_t triangle) {
    return (static_cast<std::uint64_t>(index_of(id)) + 1) << 32U | triangle;
}

/// Of `places`, a power of two.
std::size_t place_of(std::uint64_t name, std::size_t places) {
    return static_cast<std::size_t>((name * 0x9e3779b97f4a7c15ULL) >> 32U) & (places - 1);
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
    cached_.clear();
}

void ContactCache::cover(const Aabb& box, QueryStatistics* statistics) {
    const Vec3 more(margin_, kUpright, margin_);
    const Aabb wanted{box.min - more, box.max + more};
    if (!contains(covered_, box)) {
        go_on_to(wanted, statistics);
        return;
    }
    // In time, and along one axis at a time: no tick has to gather on all sides.
    for (int axis = 0; axis < 3; ++axis) {
        const double left = std::min(box.min[axis] - covered_.min[axis], covered_.max[axis] - box.max[axis]);
        if (left < kSoon * more[axis]) {
            Aabb next = covered_;
            next.min[axis] = wanted.min[axis];
            next.max[axis] = wanted.max[axis];
            go_on_to(next, statistics);
            return;
        }
    }
}

void ContactCache::go_on_to(const Aabb& box, QueryStatistics* statistics) {
    const Aabb before = covered_;
    covered_ = box;
    drop_outside();
    gather(before, statistics);
    restart_bounds();
    if (pieces_.size() < kFewPieces) {
        margin_ = std::min(kMostMargin, 1.4 * margin_);
    } else if (pieces_.size() > kManyPieces) {
        margin_ = std::max(kLeastMargin, 0.5 * margin_);
    }
}

void ContactCache::drop_outside() {
    for (std::size_t i = 0; i < pieces_.size();) {
        if (pieces_[i].box.overlaps(covered_)) {
            ++i;
            continue;
        }
        pieces_[i] = pieces_.back();
        cached_[i] = cached_.back();
        pieces_.pop_back();
        cached_.pop_back();
    }
}

/// Adds what an object has of pieces, each kind of shape in its own way.
struct ContactCache::Gathering {
    ContactCache& cache;
    ObjectId id;
    const Aabb& before;
    QueryStatistics* statistics;

    void operator()(const std::shared_ptr<const MeshCollider>& mesh) const {
        const Pose& X = cache.world_->object(id).X_world_shape;
        const auto take = [&](std::uint32_t t, const Triangle& c) {
            if (!cache.holds(id, t)) {
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
    name_pieces();
    world_->candidates(covered_, filter_, candidates_);
    for (const ObjectId id : candidates_) {
        std::visit(Gathering{*this, id, before, statistics}, world_->object(id).shape);
    }
}

/// A round solid is one piece.
void ContactCache::gather_round(ObjectId id) {
    if (!holds(id, 0)) {
        add(solid_obstacle(*world_, id), world_->bounds(id));
    }
}

/// Open addressing, at most a quarter full.
void ContactCache::name_pieces() {
    names_.assign(std::bit_ceil(std::max(kUsual, pieces_.size()) * 4), 0);
    for (const Piece& piece : pieces_) {
        const std::uint64_t name = name_of(piece.obstacle.object, piece.obstacle.triangle);
        std::size_t at = place_of(name, names_.size());
        while (names_[at] != 0) {
            at = (at + 1) & (names_.size() - 1);
        }
        names_[at] = name;
    }
}

/// Among the pieces that have been named.
bool ContactCache::holds(ObjectId id, std::uint32_t triangle) const {
    const std::uint64_t name = name_of(id, triangle);
    std::size_t at = place_of(name, names_.size());
    while (names_[at] != 0 && names_[at] != name) {
        at = (at + 1) & (names_.size() - 1);
    }
    return names_[at] == name;
}

/// A box is its twelve triangles: whoever is outside can't get in.
void ContactCache::gather_box(ObjectId id, const Box& box) {
    const Pose& X = world_->object(id).X_world_shape;
    const auto vertex = [&](unsigned i) {
        const Vec3 side((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
        return Vec3(X * side.cwiseProduct(box.half_extents));
    };
    constexpr std::array<std::array<unsigned, 4>, 6> kFaces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    const auto add_face = [&](std::uint32_t index, unsigned a, unsigned b, unsigned c) {
        if (!holds(id, index)) {
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
    cached_.emplace_back();
}

/// About the new middle. The last place that a piece was looked at from tells more than its box.
void ContactCache::restart_bounds() {
    origin_ = covered_.center();
    // Of numbers up to the size of what is covered, some roundings of float32.
    slack_ = 1e-6 * (1.0 + (covered_.max - covered_.min).norm());
    bounds_.assign((pieces_.size() + kLanes - 1) / kLanes, Bounds{});
    near_.resize(bounds_.size() * kLanes + 1);  // a place to write what is not kept
    if (!bounds_.empty()) {
        bounds_.back().rest.fill(std::numeric_limits<float>::infinity());
    }
    for (Index i = 0; i < pieces_.size(); ++i) {
        if (const Separation& s = cached_[i].places[cached_[i].last]; s.distance > 0.0) {
            set_bound(i, s.normal, s.bound(origin_));
        } else {
            bound_by_box(i);
        }
    }
}

/// `push_back` alone would take from the heap whenever there is one piece more than ever before.
void ContactCache::reserve_for(std::size_t count) {
    if (count > pieces_.capacity()) {
        const std::size_t room = std::max(kUsual, 2 * count);
        pieces_.reserve(room);
        cached_.reserve(room);
        bounds_.reserve(room / kLanes + 1);
        near_.reserve(room + kLanes + 1);
    }
}

/// The side on which the piece's box is farthest from a body in the middle.
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
    b.rest[lane] = static_cast<float>(at_origin);
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
            const float here = b.rest[i] + (b.x[i] * x + b.y[i] * y + b.z[i] * z) - b.flat[i] * aside;
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

Separation& ContactCache::measure(Index i, const Vec3& foot) {
    CachedPiece& kept = cached_[i];
    for (std::uint8_t k = 0; k < 2; ++k) {
        if (kept.places[k].foot == foot) {
            kept.last = k;
            return kept.places[k];
        }
    }
    kept.last = kept.last == 0 ? 1 : 0;
    const Obstacle& obstacle = pieces_[i].obstacle;
    const Closest c = closest_upright(settings_.core(foot), obstacle);
    Separation& s = kept.places[kept.last];
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

bool ContactCache::known_apart(Index i, const Vec3& from, const Vec3& to, double distance) const {
    const auto& places = cached_[i].places;
    return std::any_of(places.begin(), places.end(), [&](const Separation& s) {
        return s.bound(from) >= distance && s.bound(to) >= distance;  // never where the place is none
    });
}

}  // namespace campuswalk::collision
