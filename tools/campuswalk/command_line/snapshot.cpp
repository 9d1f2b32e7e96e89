#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/command_line/rendering_backend.h"
#include "tools/campuswalk/snapshot_command.h"

namespace campuswalk::tools {

namespace {

/// None when a word is no channel.
std::optional<engine::ImageChannels> channels_in(const std::string& list) {
    engine::ImageChannels channels;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        if (word == "depth") {
            channels.depth = true;
        } else if (word == "ids") {
            channels.ids = true;
        } else if (word == "normals") {
            channels.normals = true;
        } else {
            return std::nullopt;
        }
    }
    return channels;
}

std::string why_no_channels(const std::string& list) {
    return channels_in(list) ? "" : "'" + list + "' is no list of depth, ids and normals, as in depth,ids";
}

}  // namespace

void add_snapshot(Command program, Chosen& chosen) {
    const auto options = std::make_shared<SnapshotOptions>();
    Command command = program.add("snapshot", "Draw one picture of a campus");
    command.option({.names = "CAMPUS", .help = "NAME.campus.yaml", .value = "FILE", .required = true},
                   options->campus);
    command.option({.names = "--camera",
                    .help = "top for a plan of everything, a spawn to look from, or a camera as in a walk: "
                            "'{view: orbit, around: library}'",
                    .value = "CAMERA",
                    .show_default = true},
                   options->camera);
    command.option(
        {.names = "-o,--output", .help = "The PNG file to write", .value = "FILE", .required = true},
        options->output);
    const Limits<int> pixels{16, 8192};
    command.option({.names = "--width", .help = "Pixels", .show_default = true}, options->width, pixels);
    command.option({.names = "--height", .help = "Pixels", .show_default = true}, options->height, pixels);
    command.option({.names = "--light",
                    .help = "day, overcast, night or another NAME.light.yaml; or as in a walk: "
                            "'{profile: night, anti_aliasing: fxaa}'",
                    .value = "LIGHT"},
                   options->light);
    command.option(
        {.names = "--channels",
         .help = "Of depth, ids and normals, with commas: kept beside the picture, FILE-depth.png, "
                 "-ids.png, -ids.json, -normals.png",
         .value = "LIST",
         .check = why_no_channels},
        [&channels = options->channels](const std::string& list) { channels = *channels_in(list); });
    command.choices(
        {.names = "--overlay", .help = "Drawn over the picture, but not over a plan; several times"},
        {"colliders", "compass", "labels", "triggers"}, options->overlay_names);
    command.option({.names = "--tree-level",
                    .help = "Draw the boxes at this level of the collision meshes' trees",
                    .value = "N"},
                   options->overlays.tree_level, Limits<int>{0, 40});
    add_rendering_backend(command, options->backend);
    add_cache_flag(command);
    command.choose(chosen, [options] { return draw_snapshot(*options); });
}

}  // namespace campuswalk::tools
