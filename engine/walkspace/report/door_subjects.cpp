#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/report/subjects.h"
#include "scene/campus/door_leaves.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Who is no farther from a leaf than this can open it, metres.
constexpr double kWithinReach = 0.5;
/// Who stands lower than this below a leaf has stairs to climb first, metres.
constexpr double kBelowLeaf = kHighestRiser;
/// From so many of the nodes in front of a doorway it is walked through, the nearest to its middle first.
constexpr std::size_t kMostStates = 16;
/// A body on the other side has this much room from the leaf, and walks there in so many seconds.
constexpr double kBehindLeaf = 0.05;
constexpr double kLongestCrossing = 4.0;
constexpr double kWithin = 0.02;

class Doorway {
public:
    Doorway(const scene::UprightBox& leaf, const collision::MoverSettings& body) : leaf_(leaf), body_(body) {}

    bool is_within_reach(const Vec3& foot) const {
        const Vec3 local = to_leaf(foot);
        const Vec3 outside = (local.cwiseAbs() - 0.5 * leaf_.size).cwiseMax(0.0);
        return is_beside(local) && collision::horizontal_norm(outside) <= body_.radius + kWithinReach;
    }

    /// In front of the leaf, or behind it.
    bool is_before(const Vec3& foot) const {
        const Place place = to_plane(foot);
        return is_beside(to_leaf(foot)) && std::abs(place.along) <= half_width() &&
               std::abs(place.across) > half_thickness();
    }

    /// Straight through the doorway, where the leaf is just behind the body.
    Vec3 other_side(const Vec3& foot) const {
        const Place place = to_plane(foot);
        const double beyond = half_thickness() + body_.radius + kBehindLeaf;
        const double across = place.across < 0.0 ? beyond : -beyond;
        return foot + (across - place.across) * (is_along() ? leaf_.across() : leaf_.along);
    }

    /// What a body that is within reach overlaps.
    collision::Aabb surroundings() const {
        const double half = collision::horizontal_norm(0.5 * leaf_.size) + kWithinReach;
        const Vec3 reach(half, 0.5 * leaf_.size.y(), half);
        return {leaf_.center - reach, leaf_.center + reach};
    }

private:
    /// By the middle plane of the leaf, whose thinner side lies across it.
    struct Place {
        double along = 0.0;
        double across = 0.0;
    };
    Place to_plane(const Vec3& foot) const {
        const Vec3 local = to_leaf(foot);
        return is_along() ? Place{local.x(), local.z()} : Place{local.z(), local.x()};
    }
    bool is_along() const { return leaf_.size.x() >= leaf_.size.z(); }
    double half_width() const { return 0.5 * std::max(leaf_.size.x(), leaf_.size.z()); }
    double half_thickness() const { return 0.5 * std::min(leaf_.size.x(), leaf_.size.z()); }

    /// Along the leaf, +Y, and across it.
    Vec3 to_leaf(const Vec3& foot) const {
        const Vec3 from_center = foot - leaf_.center;
        return {from_center.dot(leaf_.along), from_center.y(), from_center.dot(leaf_.across())};
    }

    bool is_beside(const Vec3& local) const {
        return local.y() < 0.5 * leaf_.size.y() && local.y() + kBelowLeaf > -0.5 * leaf_.size.y();
    }

    const scene::UprightBox& leaf_;
    const collision::MoverSettings& body_;
};

class DoorFinder {
public:
    explicit DoorFinder(const SubjectSearch& search)
        : s_(search),
          body_(search.settings.strides.upright_body()),
          strider_(search.worlds[0], search.settings.strides, search.settings.solids) {}

    Subject find(const scene::DoorLeaf& leaf) {
        Subject subject{SubjectKind::door, s_.campus.models[leaf.node.model].nodes[leaf.node.node].name};
        subject.at = leaf.box.center - 0.5 * leaf.box.size.y() * Vec3::UnitY();
        const Doorway doorway(leaf.box, body_);
        const std::vector<WalkNodeId> near = nodes_near(doorway, subject.at);
        subject.reached = !near.empty();
        if (subject.reached) {
            subject.node = near.front();
            subject.walked_through = is_walked_through(doorway, near);
        } else {
            explain(doorway, subject);
        }
        return subject;
    }

private:
    /// The nearest to the point first.
    std::vector<WalkNodeId> nodes_near(const Doorway& doorway, const Vec3& point) const {
        std::vector<WalkNodeId> near = s_.reached.nodes_touching(doorway.surroundings(), body_);
        std::erase_if(near, [&](const WalkNodeId& node) {
            return !doorway.is_within_reach(s_.reached.position(node));
        });
        std::ranges::sort(near, {}, [&](const WalkNodeId& node) {
            return std::pair((s_.reached.position(node) - point).squaredNorm(), node);
        });
        return near;
    }

    /// Straight on from a node on one side until the leaf is behind the body: where a leaf has a sill or a
    /// handle, one may get far into its bounds and yet not through.
    bool is_walked_through(const Doorway& doorway, const std::vector<WalkNodeId>& near) {
        std::size_t states = 0;
        for (const WalkNodeId& node : near) {
            if (states == kMostStates) {
                return false;
            }
            if (doorway.is_before(s_.reached.position(node))) {
                ++states;
                if (leads_through(doorway, s_.reached.state_at(node, strider_))) {
                    return true;
                }
            }
        }
        return false;
    }

    bool leads_through(const Doorway& doorway, const GroundState& at) {
        const Vec3 target = doorway.other_side(at.foot);
        const StrideEnd end = strider_.walk_to(at, target, kWithin, kLongestCrossing);
        return end.kind == StrideEnd::Kind::grounded &&
               collision::horizontal_norm(end.at.foot - target) <= kWithin;
    }

    void explain(const Doorway& doorway, Subject& subject) const {
        for (std::size_t i = 0; i < s_.islands.size(); ++i) {
            if (s_.islands[i].area(s_.reached.grid) <= kNotableIsland) {
                break;  // the largest come first
            }
            const bool leads_there = std::ranges::any_of(s_.islands[i].spots, [&](const UnreachedSpot& spot) {
                return doorway.is_within_reach(spot.at.foot);
            });
            if (leads_there) {
                subject.island = i;
                return;
            }
        }
        subject.reason = {.kind = ReasonKind::no_nearer};
    }

    const SubjectSearch& s_;
    const collision::MoverSettings body_;
    Strider strider_;
};

}  // namespace

std::vector<Subject> find_doors(const SubjectSearch& search) {
    DoorFinder finder(search);
    std::vector<Subject> doors;
    for (const scene::DoorLeaf& leaf : scene::find_door_leaves(search.campus)) {
        doors.push_back(finder.find(leaf));
    }
    return doors;
}

}  // namespace campuswalk::engine
