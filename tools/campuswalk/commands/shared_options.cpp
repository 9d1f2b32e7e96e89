#include <map>
#include <string>

#include "scene/base/glob.h"
#include "scene/base/texts_of.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/commands/commands.h"

namespace campuswalk::tools {

void add_slurm(Command command, SlurmOptions& options) {
    command.choice_flag(
        {.names = "--slurm",
         .help = "Run as an array of jobs on Slurm and wait for the merged report; with script, "
                 "only write shard.sh and merge.sh, and print how to submit them: each time anew, so edit "
                 "copies"},
        "submit", {{"submit", SlurmMode::submit}, {"script", SlurmMode::script}}, options.mode);
    command.option({.names = "--partition", .help = "With --slurm: sbatch's option", .value = "NAME"},
                   options.partition);
    command.option({.names = "--account", .help = "With --slurm: sbatch's option", .value = "NAME"},
                   options.account);
    command.option(
        {.names = "--time", .help = "With --slurm: sbatch's option, the limit of each job", .value = "TIME"},
        options.time);
    command.option(
        {.names = "--mem", .help = "With --slurm: sbatch's option, the memory of each job", .value = "SIZE"},
        options.mem);
    command.option(
        {.names = "--sbatch",
         .help = "With --slurm: another option of sbatch, as in --sbatch=--qos=long; may be repeated",
         .value = "OPTION"},
        options.sbatch);
}

void check_slurm(const SlurmOptions& options) {
    if (!options.mode &&
        (options.partition || options.account || options.time || options.mem || !options.sbatch.empty())) {
        throw error_about("--slurm", "bad-value",
                          "--partition, --account, --time, --mem and --sbatch need it");
    }
}

std::string why_no_job_number(const std::string& text) {
    const bool number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return number ? "" : "it must be the number of a job";
}

void add_file_frame(Command command, scene::SceneFile& file, const std::string& whose) {
    const std::map<std::string, scene::UpAxis> axes = {{"y", scene::UpAxis::y}, {"z", scene::UpAxis::z}};
    command.choice({.names = "--up", .help = "Up axis of " + whose}, axes, file.up);
    command.option({.names = "--scale", .help = "Metres per unit of " + whose, .show_default = true},
                   file.scale, {1e-9, 1e9});
}

bool is_typed(const Command& command, const std::string& option) {
    return std::ranges::any_of(command.given_except({}),
                               [&](const std::string& word) { return word.starts_with(option); });
}

void add_rendering_backend(Command command, Backend& backend) {
    using engine::render::RenderingBackend;
    const std::map<std::string, Backend> backends = {{"auto", RenderingBackend::automatic},
                                                     {"osmesa", RenderingBackend::osmesa},
                                                     {"egl", RenderingBackend::egl},
                                                     {"none", std::nullopt}};
    command.choice({.names = "--rendering-backend",
                    .help = "What draws the pictures; auto is osmesa where it can be opened, else egl",
                    .environment = "CAMPUSWALK_RENDERING_BACKEND"},
                   backends, backend);
}

void add_tree(Command command, std::optional<collision::TreeKind>& tree) {
    const std::map<std::string, std::optional<collision::TreeKind>> trees = {
        {"bvh8", collision::TreeKind::bvh8}, {"hybrid", collision::TreeKind::hybrid}};
    command.choice({.names = "--tree",
                    .help = "What finds a mesh's triangles: the wide BVH, or the paper's tree of spheres and "
                            "oriented boxes; the log is the same [as the walk says, else bvh8]"},
                   trees, tree);
}

void add_color(Command command, ColorChoice& color) {
    const std::map<std::string, ColorChoice> colors = {
        {"auto", ColorChoice::automatic}, {"always", ColorChoice::always}, {"never", ColorChoice::never}};
    command.choice({.names = "--color", .help = "auto is on a terminal, unless NO_COLOR is set"}, colors,
                   color);
}

void add_report_geometry(Command command, ReportGeometry& geometry) {
    const std::map<std::string, ReportGeometry> geometries = {{"exact", ReportGeometry::exact},
                                                              {"simplified", ReportGeometry::simplified},
                                                              {"boxes", ReportGeometry::boxes},
                                                              {"none", ReportGeometry::none}};
    command.choice(
        {.names = "--report-geometry",
         .help = "What html reports show of campuses: every triangle, a surface that is nowhere more "
                 "than 5 cm off, the boxes of their objects, or none"},
        geometries, geometry);
}

void add_disable(Command command, std::vector<std::string>& globs) {
    command.option({.names = "--disable",
                    .help = "Objects that aren't there, such as a gate: globs, with commas between several",
                    .value = "OBJECT",
                    .is_list = true},
                   globs);
}

std::vector<bool> disabled_objects(const scene::Campus& campus, const std::vector<std::string>& globs) {
    std::vector<bool> disabled(campus.objects.size(), false);
    for (const std::string& glob : globs) {
        bool known = false;
        for (std::size_t i = 0; i < disabled.size(); ++i) {
            if (scene::glob_matches(glob, campus.objects[i].id)) {
                disabled[i] = true;
                known = true;
            }
        }
        if (!known) {
            const std::vector<std::string> ids = scene::texts_of(campus.objects, &scene::CampusObject::id);
            throw scene::InputError(
                {"--disable", 1, 1}, "unknown-name",
                "the campus has no object '" + glob + "'" + scene::did_you_mean(glob, ids));
        }
    }
    return disabled;
}

}  // namespace campuswalk::tools
