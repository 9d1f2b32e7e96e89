#include <memory>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/base/texts_of.h"
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

std::string topics_with_json() {
    std::vector<std::string> names;
    for (const help::Topic& topic : help::topics()) {
        if (topic.json != nullptr) {
            names.emplace_back(topic.name);
        }
    }
    return joined(names, ", ");
}

/// Prints the text of a topic, or the list of topics for an empty name. Returns the exit code: an unknown
/// topic is bad usage.
int print_help(const std::string& word, bool as_json, const std::vector<std::string>& names) {
    if (word.empty() && as_json) {
        throw scene::InputError({"--json", 1, 1}, "missing-key", "name a topic: " + topics_with_json());
    }
    if (word.empty()) {
        print_lines(list_of_topics());
        return kPass;
    }
    for (const help::Topic& topic : help::topics()) {
        if (topic.name == word && as_json && topic.json == nullptr) {
            throw scene::InputError(
                {"--json", 1, 1}, "bad-value",
                "'" + word + "' is for readers only; as JSON there is " + topics_with_json());
        }
        if (topic.name == word) {
            print_lines(as_json ? json_text(topic.json(), 2) : topic.text());
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
    Command command = program.add("help", "Explain files, steps, expectations, events and more");
    const std::vector<std::string> names = scene::texts_of(help::topics(), &help::Topic::name);
    command.option(
        {.names = "TOPIC", .help = "All topics are listed without one", .value = joined(names, "|")}, *topic);
    const auto as_json = std::make_shared<bool>(false);
    command.flag({.names = "--json", .help = "Print JSON, of " + topics_with_json()}, *as_json);
    command.choose(chosen, [topic, as_json, names] { return print_help(*topic, *as_json, names); });
}

}  // namespace campuswalk::tools
