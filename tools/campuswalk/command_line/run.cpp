#include <map>
#include <memory>
#include <string>

#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/run_command.h"

namespace campuswalk::tools {

void add_run(Command program, Chosen& chosen) {
    const auto options = std::make_shared<RunOptions>();
    Command command = program.add("run", "Walk scripted paths and log what happens");
    command.option({.names = "WALK", .help = "NAME.walk.yaml files", .value = "FILE", .required = true},
                   options->walks);
    command.option({.names = "--log", .help = "Write the event log to this file too", .value = "FILE"},
                   options->log);
    command.option({.names = "--jsonl", .help = "Write the events as JSON lines", .value = "FILE"},
                   options->jsonl);
    command.option({.names = "--output",
                    .help = "Folder for pictures: DIR/WALK/SNAPSHOT.png",
                    .value = "DIR",
                    .show_default = true},
                   options->output);
    const std::map<std::string, Backend> backends = {
        {"auto", Backend::automatic}, {"osmesa", Backend::osmesa}, {"none", Backend::none}};
    command.choice({.names = "--rendering-backend", .help = "What draws the pictures"}, backends,
                   options->backend);
    command.flag({.names = "-q,--quiet", .help = "Don't print the log"}, options->quiet);
    command.footer(
        "Exit code: 0 all passed, 1 an expectation failed, 2 bad usage or input (nothing of that walk was "
        "run),\n"
        "3 something failed while running, 130 interrupted.");
    command.choose(chosen, [options] { return run_walks(*options); });
}

}  // namespace campuswalk::tools
