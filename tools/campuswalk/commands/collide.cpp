#include <memory>
#include <string>

#include "scene/campus/campus_description.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/collide/parse_shape.h"
#include "tools/campuswalk/collide/print_overlaps.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/cache_choice.h"

namespace campuswalk::tools {

using namespace collide;

namespace {

struct CollideOptions {
    std::string a;  ///< a model file or a shape, see parse_shape.h
    std::string b;
    std::string pose;         ///< of b, see parse_pose; empty: where it is
    std::string pose_matrix;  ///< instead of `pose`
    scene::SceneFile frame;   ///< how files are to be read; which are a and b
    collide::Told told = collide::Told::all;
    bool json = false;
};

collision::Pose pose_of(const CollideOptions& options) {
    if (!options.pose_matrix.empty()) {
        return parse_pose_matrix(options.pose_matrix);
    }
    return options.pose.empty() ? collision::Pose{} : parse_pose(options.pose);
}

/// Holds two models or shapes against each other and prints where they overlap. Returns the exit code: kPass
/// when they are apart, kOverlapping when not.
int collide_bodies(const CollideOptions& options) {
    const collision::Pose X_a_b = pose_of(options);
    std::vector<scene::Diagnostic> warnings;
    const Body a = read_body(options.a, options.frame, warnings);
    const Body b = read_body(options.b, options.frame, warnings);
    diagnose(warnings);
    const SearchMode wanted = options.told == Told::one ? SearchMode::one : SearchMode::all;
    const Overlaps overlaps = find_overlaps(a, b, X_a_b, wanted);
    (options.json ? print_json : print_text)(a, b, overlaps, options.told);
    return overlaps.any ? kOverlapping : kPass;
}

}  // namespace

void add_collide(Command program, Chosen& chosen) {
    const auto options = std::make_shared<CollideOptions>();
    Command command = program.add("collide", "Tell where two models or shapes overlap");
    command.option({.names = "A", .help = "A model file, or a shape: see below", .required = true},
                   options->a);
    command.option({.names = "B", .help = "Likewise", .required = true}, options->b);
    command.option({.names = "--pose",
                    .help = "Where B is: rolled, pitched, yawed, moved",
                    .value = "X,Y,Z[,YAW[,PITCH[,ROLL]]]"},
                   options->pose);
    command.option({.names = "--pose-matrix",
                    .help = "The same as the rows of a 3 x 4 matrix",
                    .value = "12 NUMBERS",
                    .excludes = "--pose"},
                   options->pose_matrix);
    add_file_frame(command, options->frame, "the files");
    const auto tell = [&told = options->told](collide::Told what) { return [&told, what] { told = what; }; };
    command.flag({.names = "--first", .help = "One pair alone, as soon as it is found"},
                 tell(collide::Told::one));
    command.flag({.names = "--count", .help = "How many there are and no more", .excludes = "--first"},
                 tell(collide::Told::count));
    command.flag({.names = "--json", .help = "As JSON"}, options->json);
    add_cache_flag(command);
    command.footer(
        "Shapes, about the origin: box:WIDTH,HEIGHT,DEPTH, sphere:RADIUS, capsule:RADIUS,HEIGHT (upright,\n"
        "caps included), wheel:RADIUS,WIDTH (its axle along X). Metres and degrees, +Y up; roll is about Z,\n"
        "pitch about X, yaw about Y, each right-handed. A shape is filled; a model is its triangles, "
        "counted\n"
        "from 0 in the order of its nodes, and not what they enclose. Touching is overlapping.\n"
        "Exit code: 0 apart, 1 overlapping, 2 bad usage or input.");
    command.choose(chosen, [options] { return collide_bodies(*options); });
}

}  // namespace campuswalk::tools
