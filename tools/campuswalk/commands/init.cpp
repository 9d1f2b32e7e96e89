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
#include "tools/campuswalk/suggest/suggest_campus.h"
#include "tools/campuswalk/suggest/suggestion_text.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct InitOptions {
    fs::path folder = ".";
    scene::SceneFile model;  ///< to make a project around; no path: none
    TypedFrame typed;        ///< of the model
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

/// Throws if the file is there, or can't be written.
void require_new(const fs::path& folder, const init::NewFile& file) {
    std::error_code ignored;
    const fs::path path = folder / file.path;
    if (fs::exists(fs::symlink_status(path, ignored))) {
        throw error_about(path, "file-exists",
                          "it is there already, and init overwrites nothing; let `campuswalk init NEW` write "
                          "into a new folder, with the same --ci, and take over what you need");
    }
    require_writable_file(path, "the file can't be written here", folder);
}

/// Says what to do with a new project.
void print_next(const InitOptions& options) {
    const std::string folder = options.folder.lexically_normal().generic_string();
    print_error_line("now: " + (folder == "." ? "" : "cd " + folder + " && ") + "campuswalk run");
    if (const auto service = init::ci_file(options.service, init::publication(), 1)) {
        print_error_line("before you commit: fill in the empty lines of " + service->path);
    }
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
    require_new(options.folder, *file);
    Undo undo;
    write(options.folder / file->path, file->text, undo);
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
    print_next(options);
    return kPass;
}

/// Whether a project may have it already: then it stays as it is.
bool may_be_there(const init::NewFile& file) {
    return file.path == init::kGitIgnore || file.path.starts_with(init::kSchemaFolder);
}

/// What a project around a model needs besides its campus and walk, as far as it isn't there.
std::vector<init::NewFile> missing_files(const InitOptions& options) {
    std::vector<init::NewFile> files = init::settings_files();
    if (std::optional<init::NewFile> service = init::ci_file(options.service, init::publication(), 1)) {
        files.push_back(std::move(*service));
    }
    std::error_code ignored;
    std::erase_if(files, [&](const init::NewFile& file) {
        return may_be_there(file) && fs::exists(fs::symlink_status(options.folder / file.path, ignored));
    });
    for (const init::NewFile& file : files) {
        require_new(options.folder, file);
    }
    return files;
}

/// Throws unless the model is in the folder: its walks couldn't read it elsewhere.
void require_inside(const fs::path& folder, const scene::SceneFile& model) {
    std::error_code ignored;
    const fs::path relative =
        fs::weakly_canonical(model.path, ignored).lexically_relative(fs::weakly_canonical(folder, ignored));
    if (relative.empty() || *relative.begin() == "..") {
        throw scene::InputError(model.mark, "outside-project",
                                "the model isn't in the folder '" + folder.generic_string() +
                                    "', which becomes the project; copy it there, or name another folder");
    }
}

/// Makes the folder of a model a project: a campus, a walk on it that has been played, settings and the
/// service's file. Overwrites nothing. Returns the exit code.
int make_project_around(const InitOptions& options) {
    const scene::SceneFile& model = options.model;
    require_inside(options.folder, model);
    const std::vector<init::NewFile> files = missing_files(options);
    const std::string name = model.path.stem().string();
    SuggestRequest request;
    request.typed = options.typed;
    request.campus_file = options.folder / (name + ".campus.yaml");
    request.walk_file = options.folder / "walks" / (name + std::string(config::kWalkSuffix));
    for (const fs::path& file : {request.campus_file, request.walk_file}) {
        require_writable_file(file, "the suggestion can't be written here", options.folder);
    }
    Undo undo;
    for (const init::NewFile& file : files) {
        write(options.folder / file.path, file.text, undo);
    }
    make_folders(request.walk_file.parent_path(), undo);
    print_suggestion(suggest_campus(model, request));
    undo.finish();
    for (const init::NewFile& file : files) {
        print_written(options.folder, file);
    }
    print_next(options);
    return kPass;
}

}  // namespace

void add_init(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<InitOptions>();
    Command command =
        program.add("init", "Create a folder with a small school, walks and a CI workflow to start from");
    command.option(
        {.names = "DIR",
         .help = "A new or an empty folder; with --template none, that of a project; with --from, the "
                 "model's",
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
    command.option(
        {.names = "--from",
         .help = "A model in the folder, which becomes a project: with a campus of it, a walk that "
                 "has been played, settings and the file of --ci",
         .value = "MODEL"},
        [&model = options->model](const std::string& file) {
            model.file = file;
            model.path = file;
            model.mark.file = file;
        });
    add_file_frame(command, options->model, "the model of --from");
    command.footer(
        "Nothing is overwritten: a folder with files in it is refused, and by --template none a file that is "
        "there. By --from, too, and what may be there already (schema/, .gitignore) stays as it is.");
    command.choose(chosen, [options, command] {
        options->typed = {is_typed(command, "--up"), is_typed(command, "--scale")};
        if (!options->model.path.empty()) {
            if (is_typed(command, "--template")) {
                throw error_about("--template", "bad-value",
                                  "with --from, the campus is the model's; pass one of them");
            }
            return make_project_around(*options);
        }
        if (options->typed.up || options->typed.scale) {
            throw error_about(options->typed.up ? "--up" : "--scale", "bad-value",
                              "it is about --from; pass that, too");
        }
        return options->which == init::Template::none ? add_ci_file(*options) : make_project(*options);
    });
}

}  // namespace campuswalk::tools
