#include <memory>

#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/validate/validate_command.h"

namespace campuswalk::tools {

void add_validate(Command program, Chosen& chosen) {
    const auto options = std::make_shared<ValidateOptions>();
    Command command = program.add(
        "validate",
        "Check walks, campuses, steps, avatars, lights and walks.config.yaml without running anything");
    command.option({.names = "PATH",
                    .help = "*.walk.yaml, *.campus.yaml, *.steps.yaml, *.avatar.yaml, *.light.yaml, or "
                            "folders with such files",
                    .value = "FILE",
                    .required = true},
                   options->paths);
    const std::map<std::string, ValidateFormat> formats = {{"text", ValidateFormat::text},
                                                           {"json", ValidateFormat::json},
                                                           {"sarif", ValidateFormat::sarif},
                                                           {"github", ValidateFormat::github}};
    command.choice(
        {.names = "--format", .help = "Who reads it: you, a program, code scanning, a GitHub workflow"},
        formats, options->format);
    add_cache_flag(command);
    command.footer("Exit code: 0 all hold, 2 some don't (or bad usage).");
    command.choose(chosen, [options] { return validate_files(*options); });
}

}  // namespace campuswalk::tools
