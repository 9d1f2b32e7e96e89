#include <filesystem>
#include <memory>
#include <string>

#include "tools/campuswalk/command_line/program.h"
#include "tools/campuswalk_bench/benchmarks.h"

using namespace campuswalk::tools;

namespace {

/// `table1` has options that the others don't.
void add_table1_options(Command& command, BenchOptions& options) {
    command.option({.names = "--plot",
                    .help = "Draw time over pairs: a .svg or .png file",
                    .value = "FILE",
                    .check =
                        [](const std::string& file) {
                            const std::string extension = std::filesystem::path(file).extension().string();
                            return extension == ".svg" || extension == ".png"
                                       ? std::string()
                                       : "'" + file + "' is neither .svg nor .png";
                        }},
                   options.plot);
    command.flag({.names = "--mixed",
                  .help = "With the paper's mixed reading too: one body's boxes against the other's spheres"},
                 options.mixed);
}

/// So has `draw`.
void add_draw_options(Command& command, BenchOptions& options) {
    command.option({.names = "--folder",
                    .help = "Leave each campus as a GLB file here, and a picture of each look",
                    .value = "DIR"},
                   options.folder);
    command.option({.names = "--peer",
                    .help = "Run another program that draws, with the campus' folder as its argument: see "
                            "below; may be given several times",
                    .value = "NAME=COMMAND",
                    .check =
                        [](const std::string& peer) {
                            const std::size_t equals = peer.find('=');
                            return equals > 0 && equals < peer.size() - 1
                                       ? std::string()
                                       : "'" + peer + "' is no NAME=COMMAND";
                        }},
                   options.peers);
}

/// And `import`.
void add_import_options(Command& command, BenchOptions& options) {
    command.option({.names = "--model",
                    .help = "Read this model file, too; may be given several times",
                    .value = "FILE"},
                   options.models);
}

Command add_measurement(Command program, const std::string& name, const std::string& description,
                        const std::shared_ptr<BenchOptions>& options, Chosen& chosen) {
    Command command = program.add(name, description);
    command.option({.names = "--csv", .help = "Write every measurement to this file", .value = "FILE"},
                   options->csv);
    command.option({.names = "--rounds", .help = "How often each query or tick is timed"}, options->rounds,
                   {1, 100000});
    command.flag({.names = "--quick", .help = "Small scenes, one round: whether it works, not how fast"},
                 options->quick);
    command.footer(
        "Exit code: 0 our own engines agree with each other and are right, 1 they don't or aren't, 2 bad "
        "usage,\n3 something failed while running. Other engines are built by tools/bench; where they differ "
        "it is shown.");
    if (name == kBenchDraw) {
        command.footer(
            "A peer finds campus.glb and views.json (size, field of view, eyes and what they look at, "
            "rounds) "
            "in its\nfolder, and prints 'frame LOOK VIEW MILLISECONDS' for each picture; tools/bench draw "
            "runs "
            "three.js and VTK\nso. The CSV has a line a campus, program and look. Exit code: 0 measured, "
            "however "
            "fast, 2 bad usage, 3\nsomething failed while running.");
    } else if (name == kBenchWalk) {
        command.footer(
            "The CSV has a line a campus and controller; forbidden: how many places it got to that no person "
            "of its\nsize gets to; bullet: the better of its defaults and a tuned set. Each tick's time is "
            "the "
            "least of all\nrounds, which are the same walk to the bit.\n"
            "Exit code: 0 ours got to every goal, to no forbidden one, and was never in anything, 1 it "
            "wasn't so, "
            "2 bad\nusage, 3 something failed while running. How fast it is changes nothing. Bullet's is "
            "built "
            "by tools/bench.");
    }
    command.choose(chosen, [options, name] {
        options->which = name;
        return run_bench(*options);
    });
    return command;
}

void add_benchmarks(Command program, Chosen& chosen) {
    const auto options = std::make_shared<BenchOptions>();
    for (const BenchCommand& it : bench_commands()) {
        Command command = add_measurement(program, it.name, it.description, options, chosen);
        if (it.name == std::string("table1")) {
            add_table1_options(command, *options);
        } else if (it.name == std::string("import")) {
            add_import_options(command, *options);
        } else if (it.name == kBenchDraw) {
            add_draw_options(command, *options);
        }
    }
    add_measurement(program, kBenchAll, "All of these but walk and draw, into one CSV", options, chosen);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program(argc, argv,
                       {"campuswalk-bench", "Measures campuswalk on this machine, beside other libraries."},
                       add_benchmarks);
}
