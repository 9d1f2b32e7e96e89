#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools::completion {

namespace {

constexpr const char* kStart = R"(# Load it with: campuswalk completion fish | source
function __campuswalk_at
    set -l place ''
    for word in (commandline -opc)[2..-1]
        switch "$place/$word"
)";

constexpr const char* kEnd = R"(                set place "$place/$word"
        end
    end
    test "$place" = "$argv[1]"
end
complete -c campuswalk -f
)";

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += (c == '\'' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
    return result + "'";
}

std::string start_of(const Place& place) {
    return "complete -c campuswalk -n '__campuswalk_at \"" + place.path + "\"'";
}

std::string value_of(const KnownOption& option) {
    switch (offer_for(option)) {
        case Offer::words:
            return " -x -a " + quoted(joined(option.choices, " "));
        case Offer::files:
            return " -r -F";
        case Offer::folders:
            return " -x -a '(__fish_complete_directories)'";
        case Offer::nothing:
            break;
    }
    return option.value.empty() ? "" : " -x";
}

std::string option_line(const Place& place, const KnownOption& option) {
    std::string names;
    for (const std::string& spec : option.names) {
        names += spec.starts_with("--") ? " -l " + spec.substr(2) : " -s " + spec.substr(1);
    }
    return start_of(place) + names + value_of(option) + " -d " + quoted(option.help) + "\n";
}

std::string lines_of(const Place& place) {
    std::string text;
    for (const KnownCommand& below : place.command->commands) {
        text += start_of(place) + " -a " + below.name + " -d " + quoted(below.description) + "\n";
    }
    for (const KnownOption& option : place.command->options) {
        if (!is_positional(option)) {
            text += option_line(place, option);
        } else if (!option.choices.empty()) {
            text += start_of(place) + " -a " + quoted(joined(option.choices, " ")) + " -d " +
                    quoted(option.help) + "\n";
        }
    }
    return text + (takes_files(*place.command) ? start_of(place) + " -F\n" : "");
}

}  // namespace

std::string fish_script(const std::vector<Place>& places) {
    std::string text = kStart;
    text += "            case " + all_paths(places, " ") + "\n" + kEnd;
    for (const Place& place : places) {
        text += lines_of(place);
    }
    return text;
}

}  // namespace campuswalk::tools::completion
