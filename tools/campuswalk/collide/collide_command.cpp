#include "tools/campuswalk/collide/collide_command.h"

#include "tools/campuswalk/collide/spelling.h"
#include "tools/campuswalk/complaints.h"
#include "tools/campuswalk/exit_codes.h"

namespace campuswalk::tools {

using namespace collide;

namespace {

collision::Pose pose_of(const CollideOptions& options) {
    if (!options.pose_matrix.empty()) {
        return parse_pose_matrix(options.pose_matrix);
    }
    return options.pose.empty() ? collision::Pose{} : parse_pose(options.pose);
}

}  // namespace

int collide_bodies(const CollideOptions& options) {
    const collision::Pose X_a_b = pose_of(options);
    std::vector<scene::Diagnostic> warnings;
    const Body a = read_body(options.a, options.frame, warnings);
    const Body b = read_body(options.b, options.frame, warnings);
    diagnose(warnings);
    const Wanted wanted = options.told == Told::one ? Wanted::one : Wanted::all;
    const Overlaps overlaps = find_overlaps(a, b, X_a_b, wanted);
    (options.json ? print_json : print_text)(a, b, overlaps, options.told);
    return overlaps.any ? kOverlapping : kPass;
}

}  // namespace campuswalk::tools
