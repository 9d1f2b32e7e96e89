#include "tools/campuswalk/command_line/rendering_backend.h"

#include <map>
#include <string>

namespace campuswalk::tools {

void add_rendering_backend(Command& command, Backend& backend) {
    const std::map<std::string, Backend> backends = {{"auto", Backend::automatic},
                                                     {"osmesa", Backend::osmesa},
                                                     {"egl", Backend::egl},
                                                     {"none", Backend::none}};
    command.choice({.names = "--rendering-backend",
                    .help = "What draws the pictures; auto is osmesa where it can be opened, else egl",
                    .environment = "CAMPUSWALK_RENDERING_BACKEND"},
                   backends, backend);
}

}  // namespace campuswalk::tools
