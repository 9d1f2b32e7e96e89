#include "tools/campuswalk/run/merge_reports.h"

#include <map>
#include <memory>

#include "tools/campuswalk/command_line/commands.h"

namespace campuswalk::tools {

void add_merge_reports(Command program, Chosen& chosen) {
    const auto options = std::make_shared<MergeOptions>();
    Command command = program.add("merge-reports", "Make one report of those of a run's shards");
    command.option({.names = "REPORT",
                    .help = "What --reporter jsonl=FILE wrote, or folders to look for that in",
                    .value = "PATH",
                    .required = true},
                   options->inputs);
    command.option({.names = "--reporter",
                    .help = "dot, github, json, jsonl, junit, list or tap; with =FILE there, several times "
                            "[list]",
                    .value = "NAME[=FILE]"},
                   options->reporters);
    command.option({.names = "--output",
                    .help = "Where the pictures lie that the reports name",
                    .value = "DIR",
                    .show_default = true},
                   options->output);
    const std::map<std::string, ColorChoice> colors = {
        {"auto", ColorChoice::automatic}, {"always", ColorChoice::always}, {"never", ColorChoice::never}};
    command.choice({.names = "--color", .help = "auto is on a terminal, unless NO_COLOR is set"}, colors,
                   options->color);
    command.footer("Exit code: that of the whole run.");
    command.choose(chosen, [options] { return merge_reports(*options); });
}

}  // namespace campuswalk::tools
