#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::engine {

/// What keeps a visitor from getting on, or to a place, with the members of Reason that say more.
enum class ReasonKind : std::uint8_t {
    // These are about a passage. `measured` is what the body would have to manage, `allowed` what it manages
    // or needs, in metres; at `at`, on `object` where that is known.
    riser,     ///< a step that is too high
    ledge,     ///< higher than any riser; nothing is allowed
    slope,     ///< too steep, in degrees
    opening,   ///< too narrow; `parts` may have the object beside it that could be taken away instead
    headroom,  ///< too low
    object,    ///< that object, or its node, is in the way; `parts` may have the opening beside it
    several,   ///< all of `parts` at once
    solid,     ///< nothing that was tried gets there
    gap,       ///< nothing to walk on from `from` to `at`, `measured` apart
    sequence,  ///< `parts`, in the order in which a visitor comes upon them

    // These are about where the avatar is.
    contact,   ///< `object` is in the way at `at`; `detour` if one leads round it
    edge,      ///< the avatar stepped off `object` at `at`
    enclosed,  ///< by `object`; `parts` may have the headroom or opening that it leaves. The nearest room is
               ///< at
               ///< `room`, `measured` away; without it, there is none within `allowed`

    // These are about the place that is to be reached, `at`.
    inside,            ///< it is inside `object`
    no_ground,         ///< there is none below it
    ground_far_below,  ///< the ground is `measured` below it
    no_room,           ///< there is none to stand there
    no_nearer,  ///< `at` is the nearest that is reached, `measured` away; `object` may stop the body there
    avoided,    ///< each way leads through one of `parts`, or of `more` others
    avoided_objects,  ///< of such parts: the objects that the glob `name` matches
    avoided_circle,   ///< likewise: `measured` around the place `name`
    through,          ///< the way goes through the place `name`, and for the one of `parts` it doesn't
    unsearched,       ///< the search ended after `measured` square metres, and there is more
    falls_out,        ///< the avatar falls out of the world
    does_not_fit,     ///< the avatar, at the place `name` where the way begins
};

/// A reason as facts, in terms of the campus's files. text_of() words it.
struct Reason {
    ReasonKind kind = ReasonKind::solid;
    std::string object = {};  ///< an id; empty: none, or unknown
    std::string node = {};    ///< of the object's mesh, if its name says more than the id
    bool is_node = false;     ///< of kind `object`: without that node alone, the body gets through
    std::string name = {};
    std::optional<Eigen::Vector3d> at = {};  ///< metres
    std::optional<double> measured = {};
    std::optional<double> allowed = {};
    std::optional<double> detour = {};         ///< metres
    std::optional<Eigen::Vector3d> from = {};  ///< metres
    std::optional<Eigen::Vector3d> room = {};  ///< metres, feet
    std::optional<Eigen::Vector3d> look_at =
        {};  ///< what to look at, if not `at`: the middle of a body there
    std::int64_t more = 0;
    std::vector<Reason> parts = {};

    friend bool operator==(const Reason&, const Reason&) = default;
};

/// A route to the target that a visitor didn't get to, from where it was stopped.
struct RouteHint {
    std::string to;                        ///< the target, as the walk names it
    double length = 0.0;                   ///< metres
    std::vector<Eigen::Vector3d> by = {};  ///< where it turns first, metres
    bool turns_again = false;              ///< after these

    friend bool operator==(const RouteHint&, const RouteHint&) = default;
};

/// The kind's name in files, such as "riser" or "no_ground".
std::string_view name_of(ReasonKind kind);
/// All of them, in their order.
std::vector<ReasonKind> reason_kinds();

/// What to look at, metres; none if the reason is nowhere.
std::optional<Eigen::Vector3d> look_at(const Reason& reason);

/// Whether something may lead there: not everything was searched.
bool is_unsearched(const Reason& reason);

/// "stair (step-1)", or the object's id alone.
std::string object_text(const Reason& reason);

/// As a sentence without its full stop: "riser of 0.45 m at stair (step-1), 3.20, 0.45, -1.00; the avatar
/// steps 0.30 m". Of a sequence: "riser of 0.45 m at …, then riser of 0.50 m at …; the avatar steps 0.30 m".
std::string text_of(const Reason& reason);

/// "a route of 12.3 m leads to square by [1.20, -3.40], …: use go_to".
std::string text_of(const RouteHint& hint);

}  // namespace campuswalk::engine
