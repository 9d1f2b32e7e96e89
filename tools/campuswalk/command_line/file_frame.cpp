#include "tools/campuswalk/command_line/file_frame.h"

namespace campuswalk::tools {

void add_file_frame(Command command, scene::SceneFile& file, const std::string& whose) {
    const std::map<std::string, scene::UpAxis> axes = {{"y", scene::UpAxis::y}, {"z", scene::UpAxis::z}};
    command.choice({.names = "--up", .help = "Up axis of " + whose}, axes, file.up);
    command.option({.names = "--scale", .help = "Metres per unit of " + whose, .show_default = true},
                   file.scale, {1e-9, 1e9});
}

}  // namespace campuswalk::tools
