#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools::completion {

namespace {

constexpr const char* kStart = R"(#compdef campuswalk
# Save it as _campuswalk in a folder of $fpath, or load it with: source <(campuswalk completion zsh)
_campuswalk() {
    local place= i
    local -a plain options
    for ((i = 2; i < CURRENT; ++i)); do
        case "$place/${words[i]}" in
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

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result + "'";
}

std::string reply(const KnownOption& option) {
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

std::string words_case(const Place& place) {
    std::string plain;
    for (const KnownCommand& below : place.command->commands) {
        plain += " " + quoted(below.name + ":" + below.description);
    }
    std::string options;
    for (const KnownOption& option : place.command->options) {
        for (const std::string& word : is_positional(option) ? option.choices : option.names) {
            (is_positional(option) ? plain : options) += " " + quoted(word + ":" + option.help);
        }
    }
    return "        ('" + place.path + "') plain=(" + plain + " ) options=(" + options + " )" +
           (takes_files(*place.command) ? "; _files" : "") + " ;;\n";
}

}  // namespace

std::string zsh_script(const std::vector<Place>& places) {
    std::string text = kStart;
    text += "            (" + all_paths(places, "|") + ") place=$place/${words[i]} ;;\n";
    text += "        esac\n    done\n    case \"$place ${words[CURRENT-1]}\" in\n";
    text += cases(places, reply, words_case);
    return text + kEnd;
}

}  // namespace campuswalk::tools::completion
