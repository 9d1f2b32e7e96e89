#include <filesystem>
#include <memory>

#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/init/init_command.h"

namespace campuswalk::tools {

void add_init(Command program, Chosen& chosen) {
    const auto options = std::make_shared<InitOptions>();
    Command command =
        program.add("init", "Make a folder with a small school, walks and a CI workflow, to change");
    command.option({.names = "DIR", .help = "A new or an empty folder", .value = "DIR", .show_default = true},
                   options->folder);
    const std::map<std::string, Template> templates = {
        {"minimal", Template::minimal}, {"stairs", Template::stairs}, {"campus", Template::campus}};
    command.choice(
        {.names = "--template",
         .help = "minimal (default): a library; stairs: and a gallery; campus: and two halls more"},
        templates, options->which);
    command.footer("Nothing is overwritten: a folder with files in it is refused.");
    command.choose(chosen, [options] { return make_project(*options); });
}

}  // namespace campuswalk::tools
