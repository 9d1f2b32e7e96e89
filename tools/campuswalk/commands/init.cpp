#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/init/ci_files.h"
#include "tools/campuswalk/init/templates.h"
#include "tools/campuswalk/run/plan/find_walks.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct InitOptions {
    fs::path folder = ".";
    init::Template which = init::Template::minimal;
    init::Service service = init::Service::github;
};

/// A new repository contains only this folder.
bool is_repository_folder(const fs::path& file) {
    return file.filename() == ".git";
}

void check_folder(const fs::path& folder) {
    std::error_code ignored;
    if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored)) {
        throw error_about(folder, "not-a-folder", "a file of this name exists; name another folder");
    }
    std::error_code error;
    if (fs::is_directory(folder, ignored)) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
            if (!is_repository_folder(entry.path())) {
                throw error_about(folder, "not-empty",
                                  "the folder isn't empty ('" + entry.path().filename().string() +
                                      "'), and init overwrites nothing; name a new folder, or add CI to "
                                      "a project with --template none");
            }
        }
    }
    if (error) {
        throw error_about(folder, "not-a-folder", "the folder can't be read: " + error.message());
    }
    require_writable_folder(folder, "the project can't be written here");
}

bool is_walk(const init::NewFile& file) {
    return file.path.ends_with(".walk.yaml");
}

/// Removes the files and folders that were made, unless all of them were.
class Undo {
public:
    Undo() = default;
    Undo(const Undo&) = delete;
    Undo& operator=(const Undo&) = delete;
    ~Undo() {
        std::error_code ignored;
        for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
            fs::remove(*path, ignored);
        }
    }
    void add(const fs::path& path) { made_.push_back(path); }
    void finish() { made_.clear(); }

private:
    std::vector<fs::path> made_;
};

void make_folders(const fs::path& folder, Undo& undo) {
    if (folder.empty() || fs::is_directory(folder)) {
        return;
    }
    make_folders(folder.parent_path(), undo);
    if (fs::create_directory(folder)) {
        undo.add(folder);
    }
}

void write(const fs::path& path, const std::string& text, Undo& undo) {
    make_folders(path.parent_path(), undo);
    scene::write_file_atomically(path, text);
    undo.add(path);
}

void print_written(const fs::path& folder, const init::NewFile& file) {
    print_line("%s", (folder / file.path).lexically_normal().generic_string().c_str());
}

/// Adds the service's file, for the walks that are there, to a project. Returns the exit code.
int add_ci_file(const InitOptions& options) {
    std::error_code ignored;
    if (!fs::is_directory(options.folder, ignored)) {
        throw error_about(options.folder, "not-a-folder",
                          "there is no such folder; with --template none, name that of your project");
    }
    const std::size_t walks = find_walks({options.folder}).size();
    const std::optional<init::NewFile> file =
        init::ci_file(options.service, init::publication(), std::max<std::size_t>(walks, 1));
    if (!file) {
        throw error_about("--template", "bad-value", "with --ci none, there is nothing to write");
    }
    const fs::path path = options.folder / file->path;
    if (fs::exists(fs::symlink_status(path, ignored))) {
        throw error_about(path, "file-exists",
                          "it is there already, and init overwrites nothing; let `campuswalk init NEW` write "
                          "into a new folder, with the same --ci, and take over what you need");
    }
    require_writable_file(path, "the file can't be written here", options.folder);
    Undo undo;
    write(path, file->text, undo);
    undo.finish();
    print_written(options.folder, *file);
    print_error_line("now: fill in its empty lines, and commit it");
    return kPass;
}

/// Creates a folder with a campus, walks that pass and one that fails as expected, and a workflow that runs
/// them. Overwrites nothing: a folder with files in it is refused. Returns the exit code.
int make_project(const InitOptions& options) {
    check_folder(options.folder);
    std::vector<init::NewFile> files = init::files_of(options.which);
    const auto walks = static_cast<std::size_t>(std::count_if(files.begin(), files.end(), is_walk));
    const std::optional<init::NewFile> service = init::ci_file(options.service, init::publication(), walks);
    if (service) {
        files.push_back(*service);
    }
    Undo undo;
    for (const init::NewFile& file : files) {
        write(options.folder / file.path, file.text, undo);
    }
    undo.finish();
    for (const init::NewFile& file : files) {
        print_written(options.folder, file);
    }
    const std::string folder = options.folder.lexically_normal().generic_string();
    print_error_line("now: " + (folder == "." ? "" : "cd " + folder + " && ") + "campuswalk run");
    if (service) {
        print_error_line("before you commit: fill in the empty lines of " + service->path);
    }
    return kPass;
}

}  // namespace

void add_init(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<InitOptions>();
    Command command =
        program.add("init", "Create a folder with a small school, walks and a CI workflow to start from");
    command.option({.names = "DIR",
                    .help = "A new or an empty folder; with --template none, that of a project",
                    .value = "DIR",
                    .show_default = true},
                   options->folder);
    const std::map<std::string, init::Template> templates = {{"minimal", init::Template::minimal},
                                                             {"stairs", init::Template::stairs},
                                                             {"campus", init::Template::campus},
                                                             {"none", init::Template::none}};
    command.choice(
        {.names = "--template",
         .help = "minimal (default): a library; stairs: with a gallery; campus: with two more halls; none: "
                 "only the file of --ci, into a project that is there already"},
        templates, options->which);
    const std::map<std::string, init::Service> services = {
        {"github", init::Service::github}, {"gitlab", init::Service::gitlab}, {"none", init::Service::none}};
    command.choice({.names = "--ci", .help = "Whose CI runs the walks: github (default), gitlab or none"},
                   services, options->service);
    command.footer(
        "Nothing is overwritten: a folder with files in it is refused, and by --template none a file that is "
        "there.");
    command.choose(chosen, [options] {
        return options->which == init::Template::none ? add_ci_file(*options) : make_project(*options);
    });
}

}  // namespace campuswalk::tools
