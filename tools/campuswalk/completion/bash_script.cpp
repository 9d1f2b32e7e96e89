#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools::completion {

namespace {

constexpr const char* kStart = R"(# Load it with: source <(campuswalk completion bash)
_campuswalk() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command= words= files= i
    # bash makes three words of --option=value.
    if [[ $current == = ]]; then
        current=
    elif [[ $previous == = ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${COMP_WORDS[i]} in
)";

constexpr const char* kEnd = R"(    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"
                             [[ -z $files || $current == -* ]] || compgen -f -- "$current")
}
complete -o filenames -F _campuswalk campuswalk
)";

std::string reply(const OptionInfo& option) {
    switch (offer_for(option)) {
        case Offer::words:
            return "mapfile -t COMPREPLY < <(compgen -W '" + joined(option.choices, " ") +
                   "' -- \"$current\"); return ;;\n";
        case Offer::files:
            return "mapfile -t COMPREPLY < <(compgen -f -- \"$current\"); return ;;\n";
        case Offer::folders:
            return "mapfile -t COMPREPLY < <(compgen -d -- \"$current\"); return ;;\n";
        case Offer::nothing:
            break;
    }
    return "COMPREPLY=(); return ;;\n";
}

}  // namespace

std::string bash_script(const std::vector<CommandInfo>& commands) {
    const auto words_case = [&](const CommandInfo& command) {
        std::string words = command.name.empty() ? subcommand_names(commands, " ") : "";
        for (const OptionInfo& option : command.options) {
            words += " " + joined(is_positional(option) ? option.choices : option.names, " ");
        }
        return "        ('" + command.name + "') words='" + words + "'" +
               (takes_files(command) ? " files=1" : "") + " ;;\n";
    };
    return kStart + ("            " + subcommand_names(commands, " | ")) +
           ") command=${COMP_WORDS[i]}; break ;;\n        esac\n    done\n    case \"$command $previous\" "
           "in\n" +
           cases(commands, reply, words_case) + kEnd;
}

}  // namespace campuswalk::tools::completion
