#include <memory>
#include <string>

#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/command_line/file_frame.h"
#include "tools/campuswalk/command_line/rendering_backend.h"
#include "tools/campuswalk/info_command.h"

namespace campuswalk::tools {

void add_info(Command program, Chosen& chosen) {
    const auto options = std::make_shared<InfoOptions>();
    Command command = program.add("info", "Tell what is in a model file and what looks odd");
    command.option({.names = "SCENE",
                    .help = "A model file: glTF, OBJ, FBX, COLLADA, ...",
                    .value = "FILE",
                    .required = true},
                   [&scene = options->scene](const std::string& file) {
                       scene.file = file;
                       scene.path = file;
                       scene.mark.file = file;
                   });
    add_file_frame(command, options->scene, "the file");
    command.flag({.names = "--json", .help = "As JSON"}, options->json);
    command.option(
        {.names = "--suggest",
         .help = "Write a first campus of it, with buildings, a spawn on open ground and triggers, and "
                 "NAME.walk.yaml beside it that visits some of them",
         .value = "NAME.campus.yaml"},
        options->suggest);
    command.flag({.names = "--overwrite", .help = "What --suggest writes may be there already"},
                 options->overwrite);
    command.option({.names = "--map", .help = "Draw it from above", .value = "FILE.png"}, options->map);
    add_rendering_backend(command, options->backend);
    add_cache_flag(command);
    command.choose(chosen, [options] { return print_info(*options); });
}

}  // namespace campuswalk::tools
