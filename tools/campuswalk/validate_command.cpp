#include "tools/campuswalk/validate_command.h"

#include <cstdio>
#include <string>
#include <system_error>

#include "tools/campuswalk/complaints.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/walk_loader.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

std::string count(std::size_t number, const char* thing) {
    return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

std::string summary_of(const scene::Campus& campus) {
    return count(campus.description.buildings.size(), "building") + ", " +
           count(campus.objects.size(), "object") + ", " + count(campus.description.spawns.size(), "spawn") +
           ", " + count(campus.description.places.size(), "place");
}

/// Checks one file by what its name says it is; returns what is in it.
std::string check(WalkLoader& loader, const fs::path& file) {
    const std::string name = file.filename().string();
    if (name.ends_with(".campus.yaml")) {
        return summary_of(*loader.load_campus(file));
    }
    if (name.ends_with(".avatar.yaml")) {
        config::load_avatar(file);
        return "an avatar";
    }
    std::error_code none;
    if (!name.ends_with(".walk.yaml") && fs::is_regular_file(file, none)) {
        throw scene::InputError(
            {file.string(), 0, 0}, "file-name",
            "only NAME.walk.yaml, NAME.campus.yaml and NAME.avatar.yaml are checked; name "
            "another file or rename this one");
    }
    const LoadedWalk loaded = loader.load_walk(file);
    return count(loaded.walk.steps.size(), "step") + ", " +
           count(loaded.walk.expectations.size(), "expectation") + ", on " + loaded.walk.campus_name + " (" +
           summary_of(*loaded.campus) + ")";
}

}  // namespace

int validate_files(const std::vector<fs::path>& files) {
    WalkLoader loader;
    int exit_code = kPass;
    for (const fs::path& file : files) {
        try {
            const std::string found = check(loader, file);
            std::printf("%s: ok: %s\n", file.string().c_str(), found.c_str());
        } catch (const scene::InputError& error) {
            complain(error.diagnostics());
            exit_code = kBadInput;
        }
    }
    return exit_code;
}

}  // namespace campuswalk::tools
