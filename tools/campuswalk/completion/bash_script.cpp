#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools::completion {

namespace {

constexpr const char* kStart = R"(# Load it with: source <(campuswalk completion bash)
_campuswalk() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} place= words= files= i
    # bash makes three words of --option=value.
    if [[ $current == = ]]; then
        current=
    elif [[ $previous == = ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$place/${COMP_WORDS[i]}" in
)";

constexpr const char* kEnd = R"(    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"
                             [[ -z $files || $current == -* ]] || compgen -f -- "$current")
}
complete -o filenames -F _campuswalk campuswalk
)";

std::string reply(const KnownOption& option) {
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

std::string words_case(const Place& place) {
    std::vector<std::string> words = plain_words(*place.command);
    for (const KnownOption& option : place.command->options) {
        if (!is_positional(option)) {
            words.insert(words.end(), option.names.begin(), option.names.end());
        }
    }
    return "        '" + place.path + "') words='" + joined(words, " ") + "'" +
           (takes_files(*place.command) ? " files=1" : "") + " ;;\n";
}

}  // namespace

std::string bash_script(const std::vector<Place>& places) {
    std::string text = kStart;
    text += "            " + all_paths(places, " | ") + ") place=$place/${COMP_WORDS[i]} ;;\n";
    text += "        esac\n    done\n    case \"$place $previous\" in\n";
    text += cases(places, reply, words_case);
    return text + kEnd;
}

}  // namespace campuswalk::tools::completion
