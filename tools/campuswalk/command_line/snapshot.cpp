#include <memory>

#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/snapshot_command.h"

namespace campuswalk::tools {

void add_snapshot(Command program, Chosen& chosen) {
    const auto options = std::make_shared<SnapshotOptions>();
    Command command = program.add("snapshot", "Draw one picture of a campus");
    command.option({.names = "CAMPUS", .help = "NAME.campus.yaml", .value = "FILE", .required = true},
                   options->campus);
    command.option({.names = "--camera",
                    .help = "top for a plan of everything, or a spawn to look from",
                    .value = "NAME",
                    .show_default = true},
                   options->camera);
    command.option(
        {.names = "-o,--output", .help = "The PNG file to write", .value = "FILE", .required = true},
        options->output);
    const Limits<int> pixels{16, 8192};
    command.option({.names = "--width", .help = "Pixels", .show_default = true}, options->width, pixels);
    command.option({.names = "--height", .help = "Pixels", .show_default = true}, options->height, pixels);
    command.choose(chosen, [options] { return draw_snapshot(*options); });
}

}  // namespace campuswalk::tools
