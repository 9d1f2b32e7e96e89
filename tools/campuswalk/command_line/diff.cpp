#include <memory>

#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/command_line/rendering_backend.h"
#include "tools/campuswalk/diff_command.h"

namespace campuswalk::tools {

void add_diff(Command program, Chosen& chosen) {
    const auto options = std::make_shared<DiffOptions>();
    Command command = program.add("diff", "Show where two event logs part");
    command.option(
        {.names = "A", .help = "A log as JSON lines (run --jsonl)", .value = "FILE", .required = true},
        options->a);
    command.option({.names = "B", .help = "The log to compare with it", .value = "FILE", .required = true},
                   options->b);
    command.option({.names = "--pictures",
                    .help = "Draw both sides of the parting from above: DIR/a.png, DIR/b.png",
                    .value = "DIR"},
                   options->images);
    command.option({.names = "--walk", .help = "The walk of these logs, for --pictures", .value = "FILE"},
                   options->walk);
    add_rendering_backend(command, options->backend);
    add_cache_flag(command);
    command.footer("Exit code: 0 the same, 1 different, 2 bad usage or input, 3 something failed.");
    command.choose(chosen, [options] { return compare_logs(*options); });
}

}  // namespace campuswalk::tools
