#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools::completion {

namespace {

constexpr const char* kStart = R"(# Load it with: campuswalk completion fish | source
function __campuswalk_at
    set -l command ''
    for word in (commandline -opc)[2..-1]
        if contains -- $word )";

constexpr const char* kEnd = R"(
            set command $word
            break
        end
    end
    test "$command" = "$argv[1]"
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

std::string value_of(const OptionInfo& option) {
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

std::string option_arguments(const OptionInfo& option) {
    if (is_positional(option)) {
        return option.choices.empty() ? "" : " -a " + quoted(joined(option.choices, " "));
    }
    std::string names;
    for (const std::string& name : option.names) {
        names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    return names + value_of(option);
}

}  // namespace

std::string fish_script(const std::vector<CommandInfo>& commands) {
    std::string text = kStart + subcommand_names(commands, " ") + kEnd;
    for (const CommandInfo& command : commands) {
        const std::string start = "complete -c campuswalk -n '__campuswalk_at \"" + command.name + "\"'";
        if (!command.name.empty()) {
            text += "complete -c campuswalk -n '__campuswalk_at \"\"' -a " + command.name + " -d " +
                    quoted(command.description) + "\n";
        }
        for (const OptionInfo& option : command.options) {
            if (const std::string arguments = option_arguments(option); !arguments.empty()) {
                text += start + arguments + " -d " + quoted(option.help) + "\n";
            }
        }
        text += takes_files(command) ? start + " -F\n" : "";
    }
    return text;
}

}  // namespace campuswalk::tools::completion
