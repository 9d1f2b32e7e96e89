#include <map>
#include <memory>

#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools {

void add_completion(Command program, CommandAction& chosen) {
    using Script = std::string (*)(const std::vector<CommandInfo>&);
    const std::map<std::string, Script> scripts = {{"bash", completion::bash_script},
                                                   {"zsh", completion::zsh_script},
                                                   {"fish", completion::fish_script}};
    const auto script = std::make_shared<Script>();
    Command command =
        program.add("completion", "Print a script with which a shell completes commands and options");
    command.choice({.names = "SHELL", .help = "Whose script", .required = true}, scripts, *script);
    command.footer(
        "In the shell's own start-up file:\n"
        "  bash: source <(campuswalk completion bash)\n"
        "  zsh:  source <(campuswalk completion zsh)      after compinit\n"
        "  fish: campuswalk completion fish | source");
    command.choose(chosen, [program, script] {
        print_lines((*script)(program.describe()));
        return kPass;
    });
}

}  // namespace campuswalk::tools
