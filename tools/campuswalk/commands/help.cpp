#include <memory>
#include <string>

#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/help/help_command.h"
#include "tools/campuswalk/help/topics.h"

namespace campuswalk::tools {

void add_help(Command program, Chosen& chosen) {
    const auto topic = std::make_shared<std::string>();
    Command command = program.add("help", "Explain files, steps, expectations, events, ...");
    std::string names;
    for (const help::Topic& each : help::topics()) {
        names += (names.empty() ? "" : "|") + std::string(each.name);
    }
    command.option({.names = "TOPIC", .help = "All topics are listed without one", .value = names}, *topic);
    command.choose(chosen, [topic] { return print_help(*topic); });
}

}  // namespace campuswalk::tools
