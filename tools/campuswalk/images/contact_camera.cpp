#include "tools/campuswalk/images/contact_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "collision/world/cast.h"
#include "engine/render/geometry/camera.h"

namespace campuswalk::tools {

namespace render = engine::render;
using Eigen::Vector3d;

namespace {

constexpr double kDistance = 3.5;       // metres from the contact: a person and what is around it
constexpr double kFarEnough = 2.0;      // metres: nearer places come last
constexpr double kClosest = 0.8;        // metres: nearer, the image shows a surface and nothing else
constexpr double kClearance = 0.25;     // metres that the camera keeps from walls
constexpr double kOffSurface = 0.03;    // metres towards the avatar, for rays from the contact
constexpr double kTowardsAvatar = 0.4;  // of the way from the contact: the middle of the image
constexpr double kSeenWithin = 0.12;    // metres: surfaces no farther in front of a point don't hide it
constexpr double kFigureWithin = 0.45;  // metres: the figure is about so thick
// Small images find out what is seen from where.
constexpr int kTrialWidth = 160;  // pixels
constexpr int kTrialHeight = 90;  // pixels
constexpr std::size_t kMostTrials = 24;

// Directions of view: to the left of the direction to the contact, and down, radians. Better ones first: the
// avatar stands beside what is in its way, and both are seen from a little above.
constexpr std::array kAside = {0.7, -0.7, 1.1, -1.1, 1.5, -1.5, 0.4, -0.4, 2.1, -2.1, 3.1};
constexpr std::array kDown = {0.3, 0.65, 0.0, 1.1, -0.35};

/// The depths around a point's pixel, metres; empty if it isn't in the image.
std::vector<double> depths_around(const render::Channels& channels, const render::Viewpoint& view,
                                  const Vector3d& point) {
    std::vector<double> depths;
    const auto pixel = render::pixel_of(view, channels.width, channels.height, point);
    if (!pixel) {
        return depths;
    }
    const int x = static_cast<int>(std::floor(pixel->x()));
    const int y = static_cast<int>(std::floor(pixel->y()));
    for (int row = std::max(0, y - 1); row <= std::min(y + 1, channels.height - 1); ++row) {
        for (int column = std::max(0, x - 1); column <= std::min(x + 1, channels.width - 1); ++column) {
            const int pixel_index = row * channels.width + column;
            depths.push_back(channels.depth[static_cast<std::size_t>(pixel_index)]);
        }
    }
    return depths;
}

double depth_of(const render::Viewpoint& view, const Vector3d& point) {
    return -view.R_world_camera.col(2).dot(point - view.position);
}

/// Whether nothing is drawn in front of the point and most of what is around it. What is solid needn't be
/// drawn itself.
bool is_unhidden(const render::Channels& channels, const render::Viewpoint& view, const Vector3d& point) {
    const std::vector<double> depths = depths_around(channels, view, point);
    const double depth = depth_of(view, point);
    const auto clear = std::ranges::count_if(
        depths, [&](double each) { return each == 0.0 || each >= depth - kSeenWithin; });
    return 3 * static_cast<std::size_t>(clear) > 2 * depths.size();
}

/// Whether something is drawn there.
bool is_drawn(const render::Channels& channels, const render::Viewpoint& view, const Vector3d& point) {
    const double depth = depth_of(view, point);
    return std::ranges::any_of(depths_around(channels, view, point),
                               [&](double each) { return std::abs(each - depth) <= kFigureWithin; });
}

/// What a trial image shows; better ones are greater.
using Sight = std::tuple<bool, bool, double>;

class ContactCamera {
public:
    ContactCamera(const scene::Campus& campus, render::SnapshotRenderer& snapshot_renderer,
                  const Vector3d& contact, render::SnapshotRequest& request)
        : campus_(campus), snapshot_renderer_(snapshot_renderer), contact_(contact), request_(request) {}

    render::Viewpoint aim() {
        std::optional<Vector3d> best;
        Sight best_sight;
        std::size_t trials = 0;
        for (const Vector3d& position : positions()) {
            if (++trials > kMostTrials) {
                break;
            }
            const Sight sight = sight_from(position);
            if (!best || sight > best_sight) {
                best = position;
                best_sight = sight;
            }
            if (std::get<0>(sight) && std::get<1>(sight)) {
                break;
            }
        }
        return look_from(best.value_or(contact_));
    }

private:
    Vector3d body_at(double share) const {
        return request_.avatar.position +
               share * request_.avatar.stature * request_.profile.height * Vector3d::UnitY();
    }

    /// One that fell out of the world isn't.
    bool is_avatar_near() const { return (contact_ - body_at(0.5)).norm() < kDistance; }

    /// Horizontally from the avatar to the contact, or where it looks.
    double yaw_to_contact() const {
        const Vector3d offset = contact_ - request_.avatar.position;
        constexpr double kStraightUp = 0.05;  // metres
        return is_avatar_near() && std::hypot(offset.x(), offset.z()) > kStraightUp
                   ? std::atan2(-offset.x(), -offset.z())
                   : request_.avatar.yaw;
    }

    /// Where a camera has room, the better places first: far enough away, then in the order above.
    std::vector<Vector3d> positions() const {
        std::vector<Vector3d> far;
        std::vector<Vector3d> near;
        std::vector<Vector3d> without_room;  // for a contact inside something solid
        const double ahead = yaw_to_contact();
        const Vector3d towards = is_avatar_near() ? Vector3d(body_at(0.5) - contact_) : Vector3d::UnitY();
        const Vector3d from = contact_ + kOffSurface * towards.normalized();
        for (const double down : kDown) {
            for (const double aside : kAside) {
                const Vector3d back =
                    render::looking(from, ahead + aside, -down, request_.camera.fov).R_world_camera.col(2);
                const double free = free_distance(from, back);
                if (free >= kClosest) {
                    (free >= kFarEnough ? far : near).push_back(from + free * back);
                }
                without_room.push_back(from + kDistance * back);
            }
        }
        far.insert(far.end(), near.begin(), near.end());
        return far.empty() ? without_room : far;
    }

    double free_distance(const Vector3d& from, const Vector3d& direction) const {
        const double whole = kDistance + kClearance;
        const auto hit = collision::cast(campus_.world, {collision::Detection::solid, 0},
                                         {from, from + whole * direction}, collision::Detection::solid);
        return whole * (hit ? hit->fraction : 1.0) - kClearance;
    }

    /// So that the avatar is in the image, too.
    render::Viewpoint look_from(const Vector3d& position) {
        const Vector3d middle =
            is_avatar_near() ? Vector3d(contact_ + kTowardsAvatar * (body_at(0.5) - contact_)) : contact_;
        engine::FixedView view;
        view.position = position;
        view.look_at = engine::CameraTarget{"", std::nullopt, middle};
        request_.camera.view = view;
        return render::looking_at(position, middle, request_.camera.fov);
    }

    Sight sight_from(const Vector3d& position) {
        const render::Viewpoint view = look_from(position);
        render::SnapshotRequest trial = request_;
        trial.camera.width = kTrialWidth;
        trial.camera.height = kTrialHeight;
        const render::Channels channels = snapshot_renderer_.draw_channels(trial, {.depth = true});
        return {is_unhidden(channels, view, contact_),
                !is_avatar_near() || is_drawn(channels, view, body_at(0.85)) ||
                    is_drawn(channels, view, body_at(0.5)),
                (position - contact_).norm()};
    }

    const scene::Campus& campus_;
    render::SnapshotRenderer& snapshot_renderer_;
    const Vector3d contact_;
    render::SnapshotRequest& request_;
};

}  // namespace

render::Viewpoint aim_at_contact(const scene::Campus& campus, render::SnapshotRenderer& snapshot_renderer,
                                 const Vector3d& contact, render::SnapshotRequest& request) {
    return ContactCamera(campus, snapshot_renderer, contact, request).aim();
}

}  // namespace campuswalk::tools
