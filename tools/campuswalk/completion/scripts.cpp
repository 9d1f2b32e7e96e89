#include "tools/campuswalk/completion/scripts.h"

#include <algorithm>

#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools::completion {

Offer offer_for(const OptionInfo& option) {
    if (!option.choices.empty()) {
        return Offer::words;
    }
    return option.value == "FILE" ? Offer::files : option.value == "DIR" ? Offer::folders : Offer::nothing;
}

bool is_positional(const OptionInfo& option) {
    return !option.names.front().starts_with('-');
}

bool takes_files(const CommandInfo& command) {
    return std::ranges::any_of(command.options, [](const OptionInfo& option) {
        const Offer offer = offer_for(option);
        return is_positional(option) && (offer == Offer::files || offer == Offer::folders);
    });
}

std::string subcommand_names(const std::vector<CommandInfo>& commands, std::string_view between) {
    std::vector<std::string> names;
    for (const CommandInfo& command : commands) {
        if (!command.name.empty()) {
            names.push_back(command.name);
        }
    }
    return joined(names, between);
}

std::string cases(const std::vector<CommandInfo>& commands,
                  const std::function<std::string(const OptionInfo&)>& reply,
                  const std::function<std::string(const CommandInfo&)>& words) {
    std::string text;
    for (const CommandInfo& command : commands) {
        for (const OptionInfo& option : command.options) {
            if (is_positional(option) || option.value.empty()) {
                continue;
            }
            const std::string pattern =
                "'" + command.name + " " + joined(option.names, "'|'" + command.name + " ");
            text += "        (" + pattern + "') " + reply(option);
        }
    }
    text += "    esac\n    case $command in\n";
    for (const CommandInfo& command : commands) {
        text += words(command);
    }
    return text;
}

}  // namespace campuswalk::tools::completion
