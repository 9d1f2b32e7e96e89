#include <filesystem>
#include <memory>
#include <string>

#include "tools/campuswalk/command_line/program.h"
#include "tools/campuswalk_bench/benchmarks.h"

using namespace campuswalk::tools;

namespace {

/// The options of `table1` alone.
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
                  .help = "Include the paper's mixed reading: one body's boxes against the other's spheres"},
                 options.mixed);
}

/// The options of `draw` alone.
void add_draw_options(Command& command, BenchOptions& options) {
    command.option({.names = "--folder",
                    .help = "Save each campus as a GLB file here, and a picture of each look",
                    .value = "DIR"},
                   options.draw.folder);
    command.option(
        {.names = "--peer",
         .help =
             "Run another program that draws, with the campus' folder as its argument (see below); may be "
             "given several times",
         .value = "NAME=COMMAND",
         .check =
             [](const std::string& peer) {
                 const std::size_t equals = peer.find('=');
                 return equals > 0 && equals < peer.size() - 1 ? std::string()
                                                               : "'" + peer + "' isn't NAME=COMMAND";
             }},
        options.draw.peers);
}

/// The options of `explore` alone.
void add_explore_options(Command& command, BenchOptions& options) {
    command.option(
        {.names = "--data",
         .help = "Folder of the models of others: recast/, gazebo/ and ufaz/; without it, only the "
                 "demo campus is explored",
         .value = "DIR"},
        options.explore.data);
    command.option({.names = "--campus", .help = "Only this one; may be repeated", .value = "NAME"},
                   options.explore.campuses);
    command.choices({.names = "--allow",
                     .help = "What visitors do besides walking, in explorations and random walks; several "
                             "with commas between",
                     .is_list = true},
                    {"run", "jump"}, options.explore.allow);
    command.option({.names = "--walks", .help = "Random walks on each campus; 10000 by default"},
                   options.explore.walks, {0, 10000000});
    command.option({.names = "--steered-walks",
                    .help = "Random walks that steer in falls, on `dungeon`; 100000 by default"},
                   options.explore.steered_walks, {0, 10000000});
    command.option({.names = "--routes",
                    .help = "Routes between random pairs of places on each campus; 1000 by default"},
                   options.explore.routes, {0, 10000000});
}

/// The options of `import` alone.
void add_import_options(Command& command, BenchOptions& options) {
    command.option(
        {.names = "--model", .help = "Also read this model file; may be repeated", .value = "FILE"},
        options.models);
}

Command add_measurement(Command program, const std::string& name, const std::string& description,
                        const std::shared_ptr<BenchOptions>& options, CommandAction& chosen) {
    Command command = program.add(name, description);
    command.option({.names = "--csv", .help = "Write every measurement to this file", .value = "FILE"},
                   options->csv);
    command.option({.names = "--rounds", .help = "How often each query or tick is timed"}, options->rounds,
                   {1, 100000});
    command.flag({.names = "--quick", .help = "Small scenes, one round: whether it works, not how fast"},
                 options->quick);
    command.footer(
        "Exit code: 0 our own engines are right and agree with each other, 1 they aren't or don't,\n"
        "2 bad usage, 3 something failed while running. Other engines are built by tools/bench;\n"
        "their differences are shown.");
    if (name == kBenchDraw) {
        command.footer(
            "A peer finds campus.glb and views.json (size, field of view, eyes and their targets,\n"
            "rounds) in its folder, and prints 'frame LOOK VIEW MILLISECONDS' for each picture;\n"
            "tools/bench draw runs three.js and VTK like this. The CSV has one line per campus, program\n"
            "and look. Exit code: 0 measured, however fast, 2 bad usage, 3 something failed while\n"
            "running.");
    } else if (name == kBenchExplore) {
        command.footer(
            "The CSV has one line per campus, engine and number of threads.\n"
            "Exit code: 0 ours is the same for any number of threads, and no random walk that goes straight\n"
            "on in falls got outside, 1 otherwise, 2 bad usage, 3 something failed while running; speed has\n"
            "no influence. Recast is built by tools/bench.");
    } else if (name == kBenchWalk) {
        command.footer(
            "The CSV has one line per campus and controller; forbidden: how many goals it reached that\n"
            "no person of its size can reach; bullet: the better of its defaults and a tuned set. Each\n"
            "tick's time is the least of all rounds, which are bit for bit the same walk.\n"
            "Exit code: 0 ours reached every goal and no forbidden one, and was never inside anything,\n"
            "1 otherwise, 2 bad usage, 3 something failed while running; speed has no influence.\n"
            "Bullet's is built by tools/bench.");
    }
    command.choose(chosen, [options, name] {
        options->which = name;
        return run_bench(*options);
    });
    return command;
}

void add_benchmarks(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<BenchOptions>();
    for (const BenchCommand& it : bench_commands()) {
        Command command = add_measurement(program, it.name, it.description, options, chosen);
        if (it.name == std::string("table1")) {
            add_table1_options(command, *options);
        } else if (it.name == std::string("import")) {
            add_import_options(command, *options);
        } else if (it.name == kBenchExplore) {
            add_explore_options(command, *options);
        } else if (it.name == kBenchDraw) {
            add_draw_options(command, *options);
        }
    }
    add_measurement(program, kBenchAll, "All of these except walk, explore and draw, into one CSV", options,
                    chosen);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program(
        argc, argv,
        {"campuswalk-bench", "Measures campuswalk on this machine, compared with other libraries."},
        add_benchmarks);
}
