#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/logs/log_lines.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct DiffOptions {
    std::filesystem::path a;
    std::filesystem::path b;
    std::optional<std::filesystem::path> images;                    ///< folder for a.png and b.png
    std::optional<std::filesystem::path> walk;                      ///< of the logs; for its campus
    Backend backend = engine::render::RenderingBackend::automatic;  ///< draws the images
};

constexpr std::size_t kLinesAround = 3;

using Lines = std::vector<std::string>;

Lines read_log(const fs::path& file) {
    Lines lines = read_lines(file);
    if (lines.empty() || !is_log_header(lines.front())) {
        throw scene::InputError(
            {file.string(), 1, 1}, "no-log",
            "this isn't an event log in JSON lines; make one with campuswalk run --jsonl FILE");
    }
    return lines;
}

/// Called before anything is compared.
void check_image_options(const DiffOptions& options) {
    if (options.walk && !options.images) {
        throw error_about("--walk", "bad-value", "it is for pictures: add --pictures DIR");
    }
    if (!options.images) {
        return;
    }
    if (!options.walk) {
        throw error_about("--pictures", "bad-value",
                          "name the walk of these logs, for its campus: --walk FILE");
    }
    require_images(options.backend);
    require_writable_folder(*options.images, "pictures can't be saved here");
}

void print_log_line(char side, std::size_t index, const std::string& text) {
    print_line("%c %6zu  %s", side, index + 1, as_text_line(text).c_str());
}

/// The lines from the divergence on.
void print_side(char side, const Lines& lines, std::size_t at) {
    for (std::size_t i = at; i < std::min(at + kLinesAround, lines.size()); ++i) {
        print_log_line(side, i, lines[i]);
    }
    if (at >= lines.size()) {
        print_line("%c %6zu  (the log ends)", side, at + 1);
    }
}

/// The header of the walk that the line belongs to; a log may hold several walks.
LogHeader walk_at(const Lines& lines, std::size_t at) {
    for (std::size_t i = std::min(at + 1, lines.size()); i > 0; --i) {
        if (const std::optional<LogHeader> header = log_header(lines[i - 1])) {
            return *header;
        }
    }
    return {};
}

std::string what_differs(const Lines& a, const Lines& b, std::size_t at) {
    if (at >= a.size() || at >= b.size()) {
        return std::string(at >= a.size() ? "A" : "B") + " ends";
    }
    return "in B " + difference(a[at], b[at]).value_or("");
}

void print_divergence(const DiffOptions& options, const Lines& a, const Lines& b, std::size_t at) {
    const LogHeader header = walk_at(at < a.size() ? a : b, at);
    print_line("%s and %s part in line %zu, in the walk %s%s: %s", options.a.string().c_str(),
               options.b.string().c_str(), at + 1, header.walk.c_str(),
               header.project.empty() ? "" : (" (" + header.project + ")").c_str(),
               what_differs(a, b, at).c_str());
    print_lines("\n");
    for (std::size_t i = at > kLinesAround ? at - kLinesAround : 0; i < at; ++i) {
        print_log_line(' ', i, a[i]);
    }
    print_side('A', a, at);
    print_side('B', b, at);
}

/// The path that a log records up to a line, from the header of that line's walk on.
std::vector<Eigen::Vector3d> path_until(const Lines& lines, std::size_t at) {
    std::vector<Eigen::Vector3d> path;
    for (std::size_t i = 0; i < std::min(at + 1, lines.size()); ++i) {
        if (is_log_header(lines[i])) {
            path.clear();
        } else if (const std::optional<LoggedEvent> event = logged_event(lines[i]);
                   event && event->position) {
            path.push_back(*event->position);
        }
    }
    return path;
}

void draw_side(const scene::Campus& campus, const engine::Walk& walk, const Lines& lines, std::size_t at,
               const std::string& side, const DiffOptions& options) {
    const std::vector<Eigen::Vector3d> path = path_until(lines, at);
    if (path.empty()) {
        print_line("%s has no position up to there: no picture", side.c_str());
        return;
    }
    const fs::path file = *options.images / (side + ".png");
    draw_walked_path(campus, walk.avatar, path, side + " \u00b7 line " + std::to_string(at + 1), file,
                     options.backend);
    print_line("%s", file.generic_string().c_str());
}

/// Prints the first divergence of two logs, both sides with some lines around it. Returns the exit code.
int compare_logs(const DiffOptions& options) {
    check_image_options(options);
    const Lines a = read_log(options.a);
    const Lines b = read_log(options.b);
    std::optional<LoadedWalk> loaded;
    if (options.walk) {
        loaded = WalkLoader().load_walk(*options.walk);
    }
    const std::optional<std::size_t> at = first_divergence(a, b);
    if (!at) {
        print_line("%s and %s are the same: %zu lines", options.a.string().c_str(),
                   options.b.string().c_str(), a.size());
        return kPass;
    }
    print_divergence(options, a, b, *at);
    if (loaded) {
        print_lines("\n");
        draw_side(*loaded->campus, loaded->walk, a, *at, "a", options);
        draw_side(*loaded->campus, loaded->walk, b, *at, "b", options);
    }
    return kDifferent;
}

}  // namespace

void add_diff(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<DiffOptions>();
    Command command = program.add("diff", "Show where two event logs diverge");
    command.option(
        {.names = "A", .help = "A log as JSON lines (run --jsonl)", .value = "FILE", .required = true},
        options->a);
    command.option({.names = "B", .help = "The log to compare with it", .value = "FILE", .required = true},
                   options->b);
    command.option({.names = "--pictures",
                    .help = "Draw both sides of the divergence from above: DIR/a.png, DIR/b.png",
                    .value = "DIR"},
                   options->images);
    command.option({.names = "--walk", .help = "The walk of these logs, for --pictures", .value = "FILE"},
                   options->walk);
    add_rendering_backend(command, options->backend);
    add_import_options(command);
    add_root_option(command);
    command.footer("Exit code: 0 the same, 1 different, 2 bad usage or input, 3 something failed.");
    command.choose(chosen, [options] { return compare_logs(*options); });
}

}  // namespace campuswalk::tools
