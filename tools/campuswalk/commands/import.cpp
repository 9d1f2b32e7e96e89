#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/base/ascii.h"
#include "scene/base/utf8.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/import/numbers.h"
#include "tools/campuswalk/import/write_campus.h"
#include "tools/campuswalk/loading/model_importer.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// Whatever the word on the command line says: there is one format.
enum class SourceFormat { osm };

struct ImportOptions {
    SourceFormat format = SourceFormat::osm;
    fs::path map;
    fs::path folder;
    std::optional<std::string> name;
    std::optional<std::string> box;
    std::optional<std::string> center;
    std::optional<double> radius;
    std::optional<fs::path> heights;
    bool overwrite = false;
};

/// Bytes of the character that starts at `at`; 0 unless names of campus and walk files may have it
/// everywhere.
std::size_t plain_length(std::string_view text, std::size_t at) {
    const char c = text[at];
    const bool plain = scene::is_letter(c) || scene::is_digit(c) || c == '-' || c == '_' ||
                       static_cast<unsigned char>(c) >= 0x80;
    return plain ? scene::utf8_length(text, at) : 0;
}

/// The text with a '-' for each run of characters that aren't plain; none at its ends.
std::string plain_name(std::string_view text) {
    std::string name;
    for (std::size_t at = 0, length = 0; at < text.size(); at += std::max<std::size_t>(1, length)) {
        length = plain_length(text, at);
        if (length > 0) {
            name += text.substr(at, length);
        } else if (!name.empty() && name.back() != '-') {
            name += '-';
        }
    }
    while (!name.empty() && name.back() == '-') {
        name.pop_back();
    }
    return name;
}

bool is_plain(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size() && plain_length(text, at) > 0) {
        at += plain_length(text, at);
    }
    return at == text.size();
}

/// That of --name, or the map's file's first part: "map (1).osm" makes "map-1".
std::string name_of(const ImportOptions& options) {
    if (options.name) {
        if (options.name->empty() || !is_plain(*options.name)) {
            throw error_about("--name", "bad-value",
                              "'" + *options.name + "' is no name; use letters, digits, '-' and '_'");
        }
        return *options.name;
    }
    const std::string file = options.map.filename().string();
    const std::string name = plain_name(std::string_view(file).substr(0, file.find('.')));
    return name.empty() ? "campus" : name;
}

scene::osm::MapSection section_of(const ImportOptions& options) {
    scene::osm::MapSection section;
    if (options.box) {
        const std::vector<double> edges = numbers_in(*options.box, 4, "--bbox");
        const double turn = edges[1] > edges[3] ? 360.0 : 0.0;  // across the antimeridian
        section.box = scene::osm::GeographicBox{edges[0], edges[1], edges[2], edges[3] + turn};
        if (!(edges[0] < edges[2] && edges[1] != edges[3] && edges[0] >= -89.0 && edges[2] <= 89.0 &&
              std::abs(edges[1]) <= 180.0 && std::abs(edges[3]) <= 180.0)) {
            throw error_about("--bbox", "bad-value",
                              "'" + *options.box + "' is no box; write SOUTH,WEST,NORTH,EAST in degrees");
        }
    }
    if (options.center.has_value() != options.radius.has_value()) {
        throw error_about(options.center ? "--center" : "--radius", "bad-value",
                          "--center and --radius belong together");
    }
    if (options.center) {
        const std::vector<double> at = numbers_in(*options.center, 2, "--center");
        if (!(at[0] >= -88.0 && at[0] <= 88.0 && at[1] >= -180.0 && at[1] <= 180.0)) {
            throw error_about("--center", "bad-value",
                              "'" + *options.center + "' is no place; write LATITUDE,LONGITUDE in degrees");
        }
        section.center = {at[0], at[1]};
        section.radius = *options.radius;
    }
    return section;
}

void check_files(const ImportOptions& options, const CampusFiles& files) {
    require_writable_folder(options.folder, "the campus can't be written here");
    for (const fs::path& file : {files.model, files.campus, files.walk, files.attribution}) {
        std::error_code ignored;
        if (!options.overwrite && fs::exists(file, ignored)) {
            throw error_about(file, "file-exists",
                              "the file exists; name another folder, or pass --overwrite");
        }
        require_writable_file(file, "the campus can't be written here", options.folder);
    }
}

/// Prints the first few warnings of each code, and how many there are.
void print_warnings(const std::vector<scene::Diagnostic>& warnings) {
    constexpr std::size_t kShown = 5;
    std::vector<std::pair<std::string_view, std::size_t>> counts;
    std::vector<scene::Diagnostic> shown;
    for (const scene::Diagnostic& warning : warnings) {
        auto count =
            std::ranges::find(counts, warning.code.text(), &std::pair<std::string_view, std::size_t>::first);
        if (count == counts.end()) {
            count = counts.insert(counts.end(), {warning.code.text(), 0});
        }
        if (++count->second <= kShown) {
            shown.push_back(warning);
        }
    }
    diagnose(shown);
    for (const auto& [code, count] : counts) {
        if (count > kShown) {
            print_error_line("… and " + scene::plural(count - kShown, "more warning") + " " +
                             std::string(code));
        }
    }
}

/// Makes a campus from a map. Returns the exit code.
int import_osm(const ImportOptions& options) {
    const std::string name = name_of(options);
    const CampusFiles files = campus_files_in(options.folder, name);
    check_files(options, files);
    scene::osm::MapRequest request;
    request.file = options.map;
    request.mark.file = options.map.string();
    request.heights = options.heights.value_or(fs::path());
    request.heights_mark.file = request.heights.string();
    request.section = section_of(options);
    const scene::osm::MapFiles contents = read_osm_map(request);
    print_warnings(contents.warnings);
    const WrittenWalk walk = write_campus_files(contents, files, options.map);
    if (walk.visits == 0) {
        scene::SourceMark mark;
        mark.file = options.map.string();
        scene::DiagnosticList warnings;
        warnings.warning(
            mark, "no-visits",
            walk.obstacle.empty()
                ? "it has no door near the start; the walk only stands there"
                : "no door near the start can be reached; the walk only stands there: " + walk.obstacle);
        diagnose(warnings.all());
    }
    const auto shown = [](const fs::path& path) { return path.lexically_normal().generic_string(); };
    print_line("%s: %s", shown(files.model).c_str(), scene::plural(contents.triangles, "triangle").c_str());
    print_line("%s: %s with a name, %s, %s", shown(files.campus).c_str(),
               scene::plural(contents.draft.buildings.size(), "building").c_str(),
               scene::plural(contents.draft.places.size(), "place").c_str(),
               scene::plural(contents.draft.spawns.size(), "spawn").c_str());
    print_line("%s: %s, played", shown(files.walk).c_str(), scene::plural(walk.visits, "visit").c_str());
    print_line("%s: show it with what you publish", shown(files.attribution).c_str());
    return kPass;
}

}  // namespace

void add_import(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<ImportOptions>();
    Command command = program.add("import", "Make a campus with names, doors and a walk from a map");
    const std::map<std::string, SourceFormat> formats = {{"osm", SourceFormat::osm}};
    command.choice({.names = "FORMAT", .help = "osm: OpenStreetMap, as XML or PBF", .required = true},
                   formats, options->format);
    command.option({.names = "MAP",
                    .help = "An extract of the map, such as from openstreetmap.org's Export",
                    .value = "FILE.osm",
                    .required = true},
                   options->map);
    command.option({.names = "-o,--output",
                    .help = "The folder for campus.glb, NAME.campus.yaml, NAME.walk.yaml and ATTRIBUTION.md",
                    .value = "DIR",
                    .required = true},
                   options->folder);
    command.option(
        {.names = "--name", .help = "NAME in the files' names; default: the map's", .value = "NAME"},
        options->name);
    command.option({.names = "--bbox",
                    .help = "Only this part of the map, in degrees; default: what the file states",
                    .value = "SOUTH,WEST,NORTH,EAST"},
                   options->box);
    command.option({.names = "--center",
                    .help = "Only the square around this place, with --radius",
                    .value = "LATITUDE,LONGITUDE",
                    .excludes = "--bbox"},
                   options->center);
    command.option({.names = "--radius", .help = "Half of the square's edge", .value = "METRES"},
                   options->radius, {1.0, 10'000.0});
    command.option({.names = "--heights",
                    .help = "Heights of the ground: an Esri ASCII grid in degrees, or an SRTM tile",
                    .value = "FILE"},
                   options->heights);
    command.flag({.names = "--overwrite", .help = "Replace existing files"}, options->overwrite);
    add_import_options(command);
    command.footer(
        "The campus is a work derived from OpenStreetMap: ATTRIBUTION.md says what that asks for.");
    command.choose(chosen, [options] { return import_osm(*options); });
}

}  // namespace campuswalk::tools
