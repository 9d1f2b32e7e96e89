#include "tools/campuswalk/help/help_command.h"

#include <cstdio>
#include <string_view>
#include <vector>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/help/topics.h"

namespace campuswalk::tools {

namespace {

std::string list_of_topics() {
    std::string text = "campuswalk help TOPIC\n\n";
    for (const help::Topic& topic : help::topics()) {
        const std::string name(topic.name);
        text += "  " + name + std::string(14 - name.size(), ' ') + std::string(topic.description) + "\n";
    }
    return text + "\nOptions of a command: campuswalk COMMAND --help\n";
}

}  // namespace

int print_help(const std::string& word) {
    if (word.empty()) {
        std::fputs(list_of_topics().c_str(), stdout);
        return kPass;
    }
    std::vector<std::string> names;
    for (const help::Topic& topic : help::topics()) {
        if (topic.name == word) {
            std::fputs(topic.text().c_str(), stdout);
            return kPass;
        }
        names.emplace_back(topic.name);
    }
    std::fprintf(stderr, "error: unknown topic '%s'%s\nsee campuswalk help\n", word.c_str(),
                 scene::did_you_mean(word, names).c_str());
    return kBadInput;
}

}  // namespace campuswalk::tools
