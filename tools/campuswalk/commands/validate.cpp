#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/cache_choice.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/validate/check_config.h"
#include "tools/campuswalk/validate/findings.h"
#include "tools/campuswalk/validate/found_files.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using scene::Diagnostic;

namespace {

enum class ValidateFormat { text, json, sarif, github };

struct ValidateOptions {
    std::vector<std::filesystem::path> paths;  ///< files, or folders to look for such files in
    ValidateFormat format = ValidateFormat::text;
};

std::string count(std::size_t number, const char* thing) {
    return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

std::string summary_of(const scene::Campus& campus) {
    return count(campus.description.buildings.size(), "building") + ", " +
           count(campus.objects.size(), "object") + ", " + count(campus.description.spawns.size(), "spawn") +
           ", " + count(campus.description.places.size(), "place");
}

/// What a file is that is to be checked; one that is none or not there is taken for a walk.
FileKind checked_kind(const fs::path& file) {
    const std::optional<FileKind> kind = kind_of(file);
    std::error_code none;
    if (!kind && fs::is_regular_file(file, none)) {
        throw scene::InputError(
            {file.string(), 0, 0}, "file-name",
            "only NAME.walk.yaml, NAME.campus.yaml, NAME.avatar.yaml, NAME.light.yaml and "
            "NAME.steps.yaml are checked; name another file or rename this one");
    }
    return kind.value_or(FileKind::walk);
}

/// Checks one file by what its name says it is; returns what is in it.
std::string check(WalkLoader& loader, const fs::path& file) {
    switch (checked_kind(file)) {
        case FileKind::campus:
            return summary_of(*loader.load_campus(file));
        case FileKind::avatar:
            config::load_avatar(file);
            return "an avatar";
        case FileKind::light:
            config::load_light(file);
            return "a light";
        case FileKind::steps:
            return count(config::load_steps(file).size(), "step");
        case FileKind::config:
            return count(check_config(loader, file), "project");
        case FileKind::walk:
            break;
    }
    const LoadedWalk loaded = loader.load_walk(file);
    return count(loaded.walk.steps.size(), "step") + ", " +
           count(loaded.walk.expectations.size(), "expectation") + ", on " + loaded.walk.campus_name + " (" +
           summary_of(*loaded.campus) + ")";
}

/// Checks files and keeps what is found; text is printed as it comes.
class Validation {
public:
    explicit Validation(bool prints) : prints_(prints) {}

    void add(const fs::path& file) {
        CheckedFile checked{file.string(), false, ""};
        try {
            checked.summary = check(loader_, file);
            checked.holds = true;
            if (prints_) {
                std::printf("%s: ok: %s\n", checked.file.c_str(), checked.summary.c_str());
            }
        } catch (const scene::InputError& error) {
            tell(error.diagnostics());
        }
        findings_.files.push_back(std::move(checked));
    }

    void tell(const std::vector<Diagnostic>& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics) {
            if (told_.insert(scene::to_string(diagnostic)).second) {
                findings_.diagnostics.push_back(diagnostic);
                if (prints_) {
                    diagnose({diagnostic});
                }
            }
        }
    }

    const Findings& findings() const { return findings_; }

private:
    bool prints_;
    Findings findings_;
    std::set<std::string> told_;
    WalkLoader loader_{[this](const std::vector<Diagnostic>& warnings) { tell(warnings); }};
};

void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
}

/// Reads and checks YAML files as `run` would, and runs nothing. Returns the exit code.
int validate_files(const ValidateOptions& options) {
    Validation validation(options.format == ValidateFormat::text);
    for (const fs::path& path : options.paths) {
        try {
            for (const fs::path& file : found_files(path)) {
                validation.add(file);
            }
        } catch (const scene::InputError& error) {
            validation.tell(error.diagnostics());
        }
    }
    const Findings& findings = validation.findings();
    switch (options.format) {
        case ValidateFormat::json:
            print(as_json(findings));
            break;
        case ValidateFormat::sarif:
            print(as_sarif(findings, CAMPUSWALK_VERSION));
            break;
        case ValidateFormat::github:
            print(as_github(findings));
            break;
        case ValidateFormat::text:
            break;
    }
    const bool mistaken = std::ranges::any_of(findings.diagnostics, [](const Diagnostic& diagnostic) {
        return diagnostic.severity == scene::Severity::error;
    });
    return mistaken ? kBadInput : kPass;
}

}  // namespace

void add_validate(Command program, Chosen& chosen) {
    const auto options = std::make_shared<ValidateOptions>();
    Command command = program.add(
        "validate",
        "Check walks, campuses, steps, avatars, lights and walks.config.yaml without running anything");
    command.option({.names = "PATH",
                    .help = "*.walk.yaml, *.campus.yaml, *.steps.yaml, *.avatar.yaml, *.light.yaml, or "
                            "folders with such files",
                    .value = "FILE",
                    .required = true},
                   options->paths);
    const std::map<std::string, ValidateFormat> formats = {{"text", ValidateFormat::text},
                                                           {"json", ValidateFormat::json},
                                                           {"sarif", ValidateFormat::sarif},
                                                           {"github", ValidateFormat::github}};
    command.choice(
        {.names = "--format", .help = "Who reads it: you, a program, code scanning, a GitHub workflow"},
        formats, options->format);
    add_cache_flag(command);
    command.footer("Exit code: 0 all hold, 2 some don't (or bad usage).");
    command.choose(chosen, [options] { return validate_files(*options); });
}

}  // namespace campuswalk::tools
