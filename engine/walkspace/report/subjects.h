#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/events/reason.h"
#include "engine/script/avatar.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What of a campus one may want to get to.
enum class SubjectKind : std::uint8_t { spawn, place, building, trigger, ray, solid, door };
inline constexpr std::array kSubjectKindNames{"spawn", "place", "building", "trigger",
                                              "ray",   "solid", "door"};

/// Whether visitors want to get there, rather than only past it: all but solids and doors.
bool is_destination(SubjectKind kind);

/// One of them, and whether some walk gets there.
struct Subject {
    SubjectKind kind = SubjectKind::place;
    std::string name;
    bool reached = false;
    /// Where: of a place or a spawn, it; of a trigger, where one stands in it; of a ray, where one sees it
    /// from.
    collision::Vec3 at = collision::Vec3::Zero();
    std::optional<WalkNodeId> node = {};     ///< reached: the node nearest to it
    std::optional<std::size_t> island = {};  ///< not reached: the unreached ground that it is on
    /// It says why the subject is neither reached nor on an island, without its place. ReasonKind::no_nearer
    /// has `measured` if something that is reached lies near it, and `allowed` if it must be seen from no
    /// farther than that. ReasonKind::contact says that others hide it.
    std::optional<Reason> reason = {};
    bool walked_through = false;  ///< of a door: one can stand where its leaf hangs
};

/// What the subjects are looked for in.
struct SubjectSearch {
    const scene::Campus& campus;
    const AvatarProfile& avatar;
    const WorkerWorlds& worlds;
    const ExploreSettings& settings;
    const WalkSpace& reached;
    const std::vector<Island>& islands;
};

/// All spawns, places, buildings and objects that the visitor notices (neither disabled nor in a layer that
/// it ignores), each kind in the campus file's order; then the doors.
///   spawn, place  reached if one can walk to it from the nearest node, as the step walk_to does
///   trigger       if the body is in it at some node; a mesh trigger that isn't closed: touches its surface
///   ray           if some node's eyes see it; a sample of nodes and of its points is tried
///   solid         if a stride touched it, or a node stands on it
///   building      if a stride touched one of its solids, or one of its triggers or rays is reached: whether
///                 one gets inside is another question
///   door          see find_doors
std::vector<Subject> find_subjects(const SubjectSearch& search);

/// Finds the doors that the campus' models name (find_door_leaves), open ones too. A door is reached if the
/// body gets within half a metre of the leaf on any side, no lower than a riser below it. It is walked
/// through if the body gets so far into the leaf that the leaf can't be solid.
std::vector<Subject> find_doors(const SubjectSearch& search);

const char* name_of(SubjectKind kind);

}  // namespace campuswalk::engine
