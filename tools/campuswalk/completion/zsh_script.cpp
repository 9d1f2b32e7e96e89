#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools::completion {

namespace {

constexpr const char* kStart = R"(#compdef campuswalk
# Save it as _campuswalk in a folder of $fpath, or load it with: source <(campuswalk completion zsh)
_campuswalk() {
    local command= i
    local -a plain options
    for ((i = 2; i < CURRENT; ++i)); do
        case ${words[i]} in
)";

constexpr const char* kEnd = R"(    esac
    (( ${#plain} )) && _describe -V 'word' plain
    _describe -o 'option' options
}
if [[ $funcstack[1] == _campuswalk ]]; then
    _campuswalk "$@"
else
    compdef _campuswalk campuswalk
fi
)";

std::string reply(const OptionInfo& option) {
    switch (offer_for(option)) {
        case Offer::words:
            return "compadd -- " + joined(option.choices, " ") + "; return ;;\n";
        case Offer::files:
            return "_files; return ;;\n";
        case Offer::folders:
            return "_files -/; return ;;\n";
        case Offer::nothing:
            break;
    }
    return "return ;;\n";
}

}  // namespace

std::string zsh_script(const std::vector<CommandInfo>& commands) {
    const auto words_case = [&](const CommandInfo& command) {
        std::string plain;
        for (const CommandInfo& other : commands) {
            if (command.name.empty() && !other.name.empty()) {
                plain += " " + shell_quoted(other.name + ":" + other.description);
            }
        }
        std::string options;
        for (const OptionInfo& option : command.options) {
            for (const std::string& word : is_positional(option) ? option.choices : option.names) {
                (is_positional(option) ? plain : options) += " " + shell_quoted(word + ":" + option.help);
            }
        }
        return "        ('" + command.name + "') plain=(" + plain + " ) options=(" + options + " )" +
               (takes_files(command) ? "; _files" : "") + " ;;\n";
    };
    return kStart + ("            (" + subcommand_names(commands, "|")) +
           ") command=${words[i]}; break ;;\n        esac\n    done\n    case \"$command "
           "${words[CURRENT-1]}\" in\n" +
           cases(commands, reply, words_case) + kEnd;
}

}  // namespace campuswalk::tools::completion
