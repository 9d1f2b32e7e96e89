#include <memory>

#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/collide/collide_command.h"
#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/command_line/file_frame.h"

namespace campuswalk::tools {

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
