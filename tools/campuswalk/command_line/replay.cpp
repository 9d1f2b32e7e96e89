#include <memory>

#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/replay_command.h"

namespace campuswalk::tools {

void add_replay(Command program, Chosen& chosen) {
    const auto options = std::make_shared<ReplayOptions>();
    Command command = program.add("replay", "Walk once more what a log or a report tells of");
    command.option({.names = "RUN",
                    .help = "A log (run --jsonl) or a report (--reporter jsonl) as JSON lines",
                    .value = "FILE",
                    .required = true},
                   options->run);
    command.option(
        {.names = "--walk", .help = "A walk file that a log tells of; reports name theirs", .value = "FILE"},
        options->walks);
    command.option({.names = "--config",
                    .help = "The walks.config.yaml with the walks' projects; without, the one that a report "
                            "names, for a log the one here or above",
                    .value = "FILE"},
                   options->config);
    command.flag({.names = "--verify", .help = "Compare the hashes instead of printing the log"},
                 options->verify);
    add_cache_flag(command);
    command.footer(
        "Exit code: 0 all the same, 1 something differs, 2 bad usage or input, 3 something failed.");
    command.choose(chosen, [options] { return replay_run(*options); });
}

}  // namespace campuswalk::tools
