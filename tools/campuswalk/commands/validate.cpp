#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "config/loader/load_profile.h"
#include "config/loader/load_run.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/repository.h"
#include "tools/campuswalk/base/walk_folder.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/suggest/frame_hints.h"
#include "tools/campuswalk/validate/check_config.h"
#include "tools/campuswalk/validate/findings.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using scene::Diagnostic;
using scene::plural;

namespace {

/// Turns findings into text, all at once.
using FindingsFormat = std::string (*)(const Findings&);

struct ValidateOptions {
    std::vector<std::filesystem::path> paths;  ///< files, or folders to look for such files in
    FindingsFormat format = nullptr;           ///< null: prints each finding at once
};

/// What a file is by its name.
enum class FileKind { walk, campus, avatar, light, steps, config };

constexpr std::array<std::pair<std::string_view, FileKind>, 6> kEndings = {{
    {".walk.yaml", FileKind::walk},
    {".campus.yaml", FileKind::campus},
    {".avatar.yaml", FileKind::avatar},
    {".light.yaml", FileKind::light},
    {".steps.yaml", FileKind::steps},
    {".config.yaml", FileKind::config},
}};
constexpr const char* kCheckedFiles =
    "NAME.walk.yaml, NAME.campus.yaml, NAME.avatar.yaml, NAME.light.yaml, NAME.steps.yaml and "
    "walks.config.yaml";

std::optional<FileKind> kind_of(const fs::path& file) {
    const std::string name = file.filename().string();
    for (const auto& [ending, kind] : kEndings) {
        if (name.ends_with(ending)) {
            return kind;
        }
    }
    return std::nullopt;
}

/// The files of a known kind in a folder and below, sorted, without folders whose name starts with a dot.
/// Throws scene::InputError for a folder without any, or with one in it that can't be read.
std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    walk_folder(folder, [&](const fs::directory_entry& entry) {
        std::error_code ignored;
        if (entry.is_regular_file(ignored) && kind_of(entry.path())) {
            files.push_back(entry.path().lexically_normal());
        }
        return !entry.path().filename().native().starts_with('.');
    });
    std::ranges::sort(files, {}, [](const fs::path& file) { return file.generic_string(); });
    if (files.empty()) {
        throw error_about(folder, "no-files", std::string("none of ") + kCheckedFiles + " is in this folder");
    }
    return files;
}

/// The path itself, or the files in it if it is a folder.
std::vector<fs::path> found_files(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) ? files_below(path) : std::vector{path};
}

std::string summary_of(const scene::Campus& campus) {
    return plural(campus.description.buildings.size(), "building") + ", " +
           plural(campus.objects.size(), "object") + ", " +
           plural(campus.description.spawns.size(), "spawn") + ", " +
           plural(campus.description.places.size(), "place");
}

/// The kind of a file to be checked. One that doesn't exist counts as a walk, whose loader reports it.
FileKind checked_kind(const fs::path& file) {
    const std::optional<FileKind> kind = kind_of(file);
    std::error_code ignored;
    if (!kind && fs::is_regular_file(file, ignored)) {
        throw error_about(
            file, "file-name",
            std::string("only ") + kCheckedFiles + " are checked; name another file or rename this one");
    }
    return kind.value_or(FileKind::walk);
}

/// Checks a file of the kind that its name says; returns a summary of its contents.
std::string check(WalkLoader& loader, const fs::path& file, const WalkLoader::Warn& warn) {
    switch (checked_kind(file)) {
        case FileKind::campus:
            return summary_of(*loader.load_campus(file));
        case FileKind::avatar:
            config::load_avatar(file, search_paths());
            return "an avatar";
        case FileKind::light:
            config::load_light(file, search_paths());
            return "a light";
        case FileKind::steps:
            return plural(config::load_steps(file, search_paths()).size(), "step");
        case FileKind::config:
            return plural(check_config(loader, file, warn), "project");
        case FileKind::walk:
            break;
    }
    const LoadedWalk loaded = loader.load_walk(file);
    warn(WalkLoader::check_go_to(loaded));
    return plural(loaded.walk.steps.size(), "step") + ", " +
           plural(loaded.walk.expectations.size(), "expectation") + ", on " + loaded.walk.campus_name + " (" +
           summary_of(*loaded.campus) + ")";
}

/// Checks files and collects the findings; prints them as text at once if it `prints`.
class Validation {
public:
    explicit Validation(bool prints) : prints_(prints) {}

    void add(const fs::path& file) {
        CheckedFile checked{file.string(), false, ""};
        try {
            hint_at_frame(file);
            checked.summary = check(loader_, file, warn_);
            checked.valid = true;
            if (prints_) {
                print_line("%s: ok: %s", checked.file.c_str(), checked.summary.c_str());
            }
        } catch (const scene::InputError& error) {
            report(error.diagnostics());
        }
        findings_.files.push_back(std::move(checked));
    }

    void report(const std::vector<Diagnostic>& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics) {
            if (reported_.insert(scene::to_string(diagnostic)).second) {
                findings_.diagnostics.push_back(diagnostic);
                if (prints_) {
                    diagnose({diagnostic});
                }
            }
        }
    }

    const Findings& findings() const { return findings_; }

private:
    /// Before anything else: a walk may fail to start because its campus has another unit or upper axis.
    void hint_at_frame(const fs::path& file) {
        const std::optional<FileKind> kind = kind_of(file);
        if (kind != FileKind::campus && kind != FileKind::walk) {
            return;
        }
        const fs::path campus_file = kind == FileKind::campus ? file : loader_.read(file).walk.campus;
        if (hinted_.insert(campus_file).second) {
            report(frame_hints(*loader_.load_campus(campus_file)));
        }
    }

    bool prints_;
    std::set<fs::path> hinted_;  ///< campus files
    Findings findings_;
    std::set<std::string> reported_;
    const WalkLoader::Warn warn_ = [this](const std::vector<Diagnostic>& warnings) { report(warnings); };
    WalkLoader loader_{warn_};
};

/// Reads and checks YAML files as `run` would, and where walks go to; writes nothing. Returns the exit code.
int validate_files(const ValidateOptions& options) {
    Validation validation(options.format == nullptr);
    for (const fs::path& path : options.paths) {
        try {
            for (const fs::path& file : found_files(path)) {
                validation.add(file);
            }
        } catch (const scene::InputError& error) {
            validation.report(error.diagnostics());
        }
    }
    const Findings& findings = validation.findings();
    if (options.format != nullptr) {
        const bool commands = options.format == as_github;
        (commands ? print_commands : print_lines)(
            options.format(with_paths_in_repository(start_in_repository(environment_variable), findings)));
    }
    const bool has_errors = std::ranges::any_of(findings.diagnostics, [](const Diagnostic& diagnostic) {
        return diagnostic.severity == scene::Severity::error;
    });
    return has_errors ? kBadInput : kPass;
}

}  // namespace

void add_validate(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<ValidateOptions>();
    Command command = program.add(
        "validate", "Check walks, with the ways of their go_to, campuses and the other YAML files");
    command.option({.names = "PATH",
                    .help = "*.walk.yaml, *.campus.yaml, *.steps.yaml, *.avatar.yaml, *.light.yaml, or "
                            "folders with such files",
                    .value = "FILE",
                    .required = true},
                   options->paths);
    const std::map<std::string, FindingsFormat> formats = {
        {"text", nullptr}, {"json", as_json}, {"sarif", as_sarif}, {"github", as_github}};
    command.choice({.names = "--format", .help = "For people, programs, code scanning or a GitHub workflow"},
                   formats, options->format);
    add_import_options(command);
    add_root_option(command);
    command.footer("Exit code: 0 all files are valid, 2 some aren't, or bad usage.");
    command.choose(chosen, [options] { return validate_files(*options); });
}

}  // namespace campuswalk::tools
