#include <memory>

#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/completion/completion_command.h"

namespace campuswalk::tools {

void add_completion(Command program, Chosen& chosen) {
    const auto shell = std::make_shared<Shell>(Shell::bash);
    Command command =
        program.add("completion", "Print a script with which a shell completes commands and options");
    const std::map<std::string, Shell> shells = {
        {"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}};
    command.choice({.names = "SHELL", .help = "Whose script", .required = true}, shells, *shell);
    command.footer(
        "In the shell's own start-up file:\n"
        "  bash: source <(campuswalk completion bash)\n"
        "  zsh:  source <(campuswalk completion zsh)      after compinit\n"
        "  fish: campuswalk completion fish | source");
    command.choose(chosen, [program, shell] { return print_completion(program.known(), *shell); });
}

}  // namespace campuswalk::tools
