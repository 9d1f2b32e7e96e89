#include <filesystem>
#include <memory>
#include <vector>

#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/validate_command.h"

namespace campuswalk::tools {

void add_validate(Command program, Chosen& chosen) {
    const auto files = std::make_shared<std::vector<std::filesystem::path>>();
    Command command = program.add("validate", "Check walks, campuses and avatars without running anything");
    command.option({.names = "FILE", .help = "*.walk.yaml, *.campus.yaml or *.avatar.yaml", .required = true},
                   *files);
    command.choose(chosen, [files] { return validate_files(*files); });
}

}  // namespace campuswalk::tools
