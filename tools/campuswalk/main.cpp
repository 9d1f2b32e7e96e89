#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/campuswalk/bench/bench_command.h"
#include "tools/campuswalk/collide/collide_command.h"
#include "tools/campuswalk/complaints.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/info_command.h"
#include "tools/campuswalk/run_command.h"
#include "tools/campuswalk/snapshot_command.h"
#include "tools/campuswalk/standard_streams.h"
#include "tools/campuswalk/validate_command.h"

using namespace campuswalk;
using namespace campuswalk::tools;

namespace {

/// What the command line asks for, kept where CLI11 writes to.
struct Arguments {
    RunOptions run;
    std::vector<std::filesystem::path> validate;
    InfoOptions info;
    CollideOptions collide;
    SnapshotOptions snapshot;
    BenchOptions bench;
    std::function<int()> chosen;
};

constexpr const char* kVersion = "campuswalk " CAMPUSWALK_VERSION;

CLI::App* add_command(CLI::App& app, const char* name, const char* description) {
    CLI::App* command = app.add_subcommand(name, description);
    command->set_version_flag("--version", kVersion);
    return command;
}

/// An option that takes one of a few words.
template <typename Value>
void add_choice(CLI::App& command, const char* name, const std::map<std::string, Value>& choices,
                Value& target, const std::string& description) {
    std::string words;
    for (const auto& [word, value] : choices) {
        words += (words.empty() ? "" : "|") + word;
    }
    command
        .add_option_function<std::string>(
            name, [choices, &target](const std::string& word) { target = choices.at(word); }, description)
        ->check([choices, words](const std::string& word) {
            return choices.contains(word) ? std::string() : "'" + word + "' is none of " + words;
        })
        ->type_name(words);
}

/// How model files are to be read that nothing else describes.
void add_file_frame(CLI::App& command, scene::SceneFile& file, const std::string& whose) {
    const std::map<std::string, scene::UpAxis> axes = {{"y", scene::UpAxis::y}, {"z", scene::UpAxis::z}};
    add_choice(command, "--up", axes, file.up, "Up axis of " + whose);
    command.add_option("--scale", file.scale, "Metres per unit of " + whose)
        ->check(CLI::Range(1e-9, 1e9))
        ->capture_default_str();
}

void add_run(CLI::App& app, Arguments& arguments) {
    RunOptions& run = arguments.run;
    CLI::App* command = add_command(app, "run", "Walk scripted paths and log what happens");
    command->add_option("WALK", run.walks, "NAME.walk.yaml files")->required()->type_name("FILE");
    command->add_option("--log", run.log, "Write the event log to this file too")->type_name("FILE");
    command->add_option("--jsonl", run.jsonl, "Write the events as JSON lines")->type_name("FILE");
    command->add_option("--output", run.output, "Folder for pictures: DIR/WALK/SNAPSHOT.png")
        ->type_name("DIR")
        ->capture_default_str();
    const std::map<std::string, Backend> backends = {
        {"auto", Backend::automatic}, {"osmesa", Backend::osmesa}, {"none", Backend::none}};
    add_choice(*command, "--rendering-backend", backends, run.backend, "What draws the pictures");
    command->add_flag("-q,--quiet", run.quiet, "Don't print the log");
    command->callback([&] { arguments.chosen = [&] { return run_walks(run); }; });
    command->footer(
        "Exit code: 0 all passed, 1 an expectation failed, 2 bad usage or input (nothing of that walk was "
        "run),\n"
        "3 something failed while running, 130 interrupted.");
}

void add_validate(CLI::App& app, Arguments& arguments) {
    CLI::App* command =
        add_command(app, "validate", "Check walks, campuses and avatars without running anything");
    command->add_option("FILE", arguments.validate, "*.walk.yaml, *.campus.yaml or *.avatar.yaml")
        ->required()
        ->type_name("");
    command->callback([&] { arguments.chosen = [&] { return validate_files(arguments.validate); }; });
}

void add_info(CLI::App& app, Arguments& arguments) {
    InfoOptions& info = arguments.info;
    CLI::App* command = add_command(app, "info", "Tell what is in a model file and what looks odd");
    command
        ->add_option_function<std::string>(
            "SCENE",
            [&](const std::string& file) {
                info.scene.file = file;
                info.scene.path = file;
                info.scene.mark.file = file;
            },
            "A model file: glTF, OBJ, FBX, COLLADA, ...")
        ->required()
        ->type_name("FILE");
    add_file_frame(*command, info.scene, "the file");
    command->add_flag("--json", info.json, "As JSON");
    command->callback([&] { arguments.chosen = [&] { return print_info(info); }; });
}

void add_collide(CLI::App& app, Arguments& arguments) {
    CollideOptions& options = arguments.collide;
    CLI::App* command = add_command(app, "collide", "Tell where two models or shapes overlap");
    command->add_option("A", options.a, "A model file, or a shape: see below")->required()->type_name("");
    command->add_option("B", options.b, "Likewise")->required()->type_name("");
    CLI::Option* pose =
        command->add_option("--pose", options.pose, "Where B is: rolled, pitched, yawed, moved")
            ->type_name("X,Y,Z[,YAW[,PITCH[,ROLL]]]");
    command->add_option("--pose-matrix", options.pose_matrix, "The same as the rows of a 3 x 4 matrix")
        ->type_name("12 NUMBERS")
        ->excludes(pose);
    add_file_frame(*command, options.frame, "the files");
    CLI::Option* first = command->add_flag_callback(
        "--first", [&] { options.told = collide::Told::one; }, "One pair alone, as soon as it is found");
    command
        ->add_flag_callback(
            "--count", [&] { options.told = collide::Told::count; }, "How many there are and no more")
        ->excludes(first);
    command->add_flag("--json", options.json, "As JSON");
    command->callback([&] { arguments.chosen = [&] { return collide_bodies(options); }; });
    command->footer(
        "Shapes, about the origin: box:WIDTH,HEIGHT,DEPTH, sphere:RADIUS, capsule:RADIUS,HEIGHT (upright,\n"
        "caps included), wheel:RADIUS,WIDTH (its axle along X). Metres and degrees, +Y up; roll is about Z,\n"
        "pitch about X, yaw about Y, each right-handed. A shape is filled; a model is its triangles, "
        "counted\n"
        "from 0 in the order of its nodes, and not what they enclose. Touching is overlapping.\n"
        "Exit code: 0 apart, 1 overlapping, 2 bad usage or input.");
}

void add_snapshot(CLI::App& app, Arguments& arguments) {
    SnapshotOptions& snapshot = arguments.snapshot;
    CLI::App* command = add_command(app, "snapshot", "Draw one picture of a campus");
    command->add_option("CAMPUS", snapshot.campus, "NAME.campus.yaml")->required()->type_name("FILE");
    command->add_option("--camera", snapshot.camera, "top for a plan of everything, or a spawn to look from")
        ->capture_default_str()
        ->type_name("NAME");
    command->add_option("-o,--output", snapshot.output, "The PNG file to write")
        ->required()
        ->type_name("FILE");
    command->add_option("--width", snapshot.width, "Pixels")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    command->add_option("--height", snapshot.height, "Pixels")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    command->callback([&] { arguments.chosen = [&] { return draw_snapshot(snapshot); }; });
}

/// `table1` has options that the others don't.
void add_table1_options(CLI::App& command, BenchOptions& options) {
    command.add_option("--plot", options.plot, "Draw time over pairs: a .svg or .png file")
        ->check([](const std::string& file) {
            const std::string extension = std::filesystem::path(file).extension().string();
            return extension == ".svg" || extension == ".png" ? std::string()
                                                              : "'" + file + "' is neither .svg nor .png";
        })
        ->type_name("FILE");
    command.add_flag("--mixed", options.mixed,
                     "With the paper's mixed reading too: one body's boxes against the other's spheres");
}

CLI::App* add_bench_command(CLI::App& bench, const char* name, const char* description,
                            Arguments& arguments) {
    BenchOptions& options = arguments.bench;
    CLI::App* command = add_command(bench, name, description);
    command->add_option("--csv", options.csv, "Write every measurement to this file")->type_name("FILE");
    command->add_option("--rounds", options.rounds, "How often each query or tick is timed")
        ->check(CLI::Range(1, 100000));
    command->add_flag("--quick", options.quick, "Small scenes, one round: whether it works, not how fast");
    command->callback([&arguments, &options, name] {
        options.which = name;
        arguments.chosen = [&options] { return run_bench(options); };
    });
    command->footer(
        "Exit code: 0 our own engines agree with each other and are right, 1 they don't or aren't, 2 bad "
        "usage,\n3 something failed while running. Other engines are built by tools/bench; where they differ "
        "it is shown.");
    if (name == std::string(kBenchWalk)) {
        command->footer(
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
    return command;
}

void add_bench(CLI::App& app, Arguments& arguments) {
    CLI::App* bench = add_command(app, "bench", "Measure on this machine, beside other libraries");
    bench->require_subcommand(1);
    for (const BenchCommand& it : bench_commands()) {
        CLI::App* command = add_bench_command(*bench, it.name, it.description, arguments);
        if (it.name == std::string("table1")) {
            add_table1_options(*command, arguments.bench);
        }
    }
    add_bench_command(*bench, kBenchAll, "All of these but walk, into one CSV", arguments);
}

int guarded(const std::function<int()>& command) {
    try {
        const int exit_code = command();
        check_standard_output();
        return exit_code;
    } catch (const scene::InputError& error) {
        complain(error.diagnostics());
        return kBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return kRunFailed;
    }
}

/// CLI11 only says that a command is missing when it doesn't know the one that is there.
std::string mistake_before_a_command(const CLI::App& app) {
    std::vector<std::string> names;
    std::string list;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
        list += (list.empty() ? "" : ", ") + names.back();
    }
    const std::vector<std::string> unknown = app.remaining();
    if (unknown.empty()) {
        return "a command is needed: " + list;
    }
    const std::string& word = unknown.front();
    return "there is no " + std::string(word.starts_with('-') ? "option" : "command") + " '" + word + "'" +
           scene::did_you_mean(word, names);
}

std::string explanation(const CLI::App* app, const CLI::Error& error) {
    std::string path = app->get_name();
    while (!app->get_subcommands().empty()) {
        app = app->get_subcommands().front();
        path += " " + app->get_name();
    }
    const bool has_commands = !app->get_subcommands({}).empty();
    return "error: " + (has_commands ? mistake_before_a_command(*app) : error.what()) + "\nsee " + path +
           " --help\n";
}

}  // namespace

int main(int argc, char** argv) {
    guard_standard_streams();
    CLI::App app("Walks scripted paths through virtual campuses without a screen.", "campuswalk");
    app.set_version_flag("--version", kVersion);
    app.require_subcommand(1);
    app.failure_message(explanation);
    Arguments arguments;
    add_run(app, arguments);
    add_validate(app, arguments);
    add_info(app, arguments);
    add_collide(app, arguments);
    add_snapshot(app, arguments);
    add_bench(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return guarded([&] { return app.exit(error) == 0 ? kPass : kBadInput; });
    }
    return guarded(arguments.chosen);
}
