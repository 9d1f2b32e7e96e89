#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/commands/commands.h"
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

/// Prints the text of a topic, or the list of topics for an empty name. Returns the exit code: an unknown
/// topic is bad usage.
int print_help(const std::string& word, const std::vector<std::string>& names) {
    if (word.empty()) {
        print_lines(list_of_topics());
        return kPass;
    }
    for (const help::Topic& topic : help::topics()) {
        if (topic.name == word) {
            print_lines(topic.text());
            return kPass;
        }
    }
    print_error_line("error: unknown topic '" + word + "'" + scene::did_you_mean(word, names));
    print_error_line("see campuswalk help");
    return kBadInput;
}

}  // namespace

void add_help(Command program, CommandAction& chosen) {
    const auto topic = std::make_shared<std::string>();
    Command command = program.add("help", "Explain files, steps, expectations, events, ...");
    std::vector<std::string> names;
    for (const help::Topic& each : help::topics()) {
        names.emplace_back(each.name);
    }
    command.option(
        {.names = "TOPIC", .help = "All topics are listed without one", .value = joined(names, "|")}, *topic);
    command.choose(chosen, [topic, names] { return print_help(*topic, names); });
}

}  // namespace campuswalk::tools
