#include "config/loader/load_run.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "config/loader/avatar_search.h"
#include "config/loader/campus_names.h"
#include "config/loader/checked_map.h"
#include "config/loader/names.h"
#include "config/loader/read_avatar.h"
#include "config/loader/read_campus.h"
#include "config/loader/read_steps.h"
#include "config/loader/read_walk.h"
#include "config/loader/source_text.h"
#include "config/loader/yaml_file.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

using engine::AvatarProfile;
using scene::CampusDescription;
using scene::Diagnostic;
using scene::DiagnosticList;
using scene::SourceMark;

namespace {

SourceMark whole_file(const fs::path& file) {
    return {shown_path(file), 0, 0};
}

/// A file that is included twice is read twice; its mistakes are told once.
void drop_repeated(std::vector<Diagnostic>& diagnostics) {
    std::set<std::string> told;
    std::erase_if(diagnostics, [&](const Diagnostic& d) { return !told.insert(scene::to_string(d)).second; });
}

/// `first`, then the files it names as they were read; the complaints of each from top to bottom.
void throw_in_order(const DiagnosticList& diagnostics, const SourceMark& first) {
    if (!diagnostics.has_errors()) {
        return;
    }
    std::vector<Diagnostic> sorted = diagnostics.all();
    std::vector<std::string> files = {first.file};
    for (const Diagnostic& diagnostic : sorted) {
        if (std::ranges::find(files, diagnostic.mark.file) == files.end()) {
            files.push_back(diagnostic.mark.file);
        }
    }
    std::ranges::stable_sort(sorted, {}, [&](const Diagnostic& diagnostic) {
        const SourceMark& mark = diagnostic.mark;
        return std::tuple(std::ranges::find(files, mark.file) - files.begin(), mark.line, mark.column);
    });
    drop_repeated(sorted);
    throw scene::InputError(std::move(sorted));
}

/// `asked_at` is where the file is named: another file, or itself when the user named it.
std::optional<CampusDescription> open_campus(const fs::path& path, const SourceMark& asked_at,
                                             DiagnosticList& diagnostics) {
    const auto file = YamlFile::open(path, ".campus.yaml", asked_at, diagnostics);
    if (!file) {
        return std::nullopt;
    }
    CampusDescription campus = read_campus(file->root(), path.parent_path());
    campus.name = file->name();
    campus.mark = file->mark();
    return campus;
}

AvatarProfile open_avatar(const fs::path& path, const SourceMark& asked_at, DiagnosticList& diagnostics) {
    AvatarProfile profile;
    if (const auto file = YamlFile::open(path, ".avatar.yaml", asked_at, diagnostics)) {
        CheckedMap map(file->root(), "an avatar");
        read_avatar_fields(map, profile);
        map.refuse_other_keys();
    }
    return profile;
}

/// Follows the names that a walk file gives of others.
class RunReader {
public:
    RunReader(const fs::path& walk_file, const SearchPaths& search, DiagnosticList& diagnostics)
        : walk_file_(walk_file),
          folder_(walk_file.parent_path()),
          search_(search),
          diagnostics_(diagnostics) {}

    Run read(const YamlFile& file) {
        CheckedMap map(file.root(), "a walk");
        Run run;
        std::optional<CampusDescription> campus = read_campus_of(map, run.walk);
        const CampusNames names(campus ? &*campus : nullptr);
        if (const auto avatar = map.find("avatar")) {
            run.walk.avatar = read_avatar_of(*avatar, names);
        }
        read_walk(map, names, walk_file_, run.walk);
        map.refuse_other_keys();
        if (campus) {
            run.campus = std::move(*campus);
        }
        return run;
    }

private:
    std::optional<CampusDescription> read_campus_of(CheckedMap& map, engine::Walk& walk) {
        const auto node = map.require("campus");
        const auto written = node ? node->line() : std::nullopt;
        if (!written) {
            return std::nullopt;
        }
        walk.campus = folder_ / *written;
        std::optional<CampusDescription> campus = open_campus(walk.campus, node->mark(), diagnostics_);
        walk.campus_name = campus ? campus->name : "";
        return campus;
    }

    /// A profile's name, or a map with the profile and the fields that differ.
    AvatarProfile read_avatar_of(const CheckedNode& node, const CampusNames& names) {
        if (node.is_scalar()) {
            return named_avatar(node);
        }
        if (!node.is_map()) {
            node.complain("wrong-type", "'avatar' must be a profile's name or {profile: NAME, …}");
            return {};
        }
        CheckedMap map(node, "'avatar'");
        const auto name = map.require("profile");
        AvatarProfile profile = name ? named_avatar(*name) : AvatarProfile{};
        for (const CheckedNode& layer : read_avatar_fields(map, profile)) {
            names.check_layer(layer, layer.text().value_or(""));
        }
        map.refuse_other_keys();
        return profile;
    }

    AvatarProfile named_avatar(const CheckedNode& node) {
        const std::optional<std::string> name = kebab_name(node);
        const auto file =
            name ? find_avatar(node, *name, avatar_folders(folder_, search_.avatars)) : std::nullopt;
        return file ? open_avatar(*file, node.mark(), diagnostics_) : AvatarProfile{};
    }

    fs::path walk_file_;
    fs::path folder_;
    const SearchPaths& search_;
    DiagnosticList& diagnostics_;
};

}  // namespace

Run load_run(const fs::path& walk_file, const SearchPaths& search) {
    DiagnosticList diagnostics;
    Run run;
    const SourceMark mark = whole_file(walk_file);
    if (const auto file = YamlFile::open(walk_file, ".walk.yaml", mark, diagnostics)) {
        run = RunReader(walk_file, search, diagnostics).read(*file);
        run.walk.name = file->name();
    }
    run.walk.mark = mark;
    throw_in_order(diagnostics, mark);
    return run;
}

CampusDescription load_campus_description(const fs::path& campus_file) {
    DiagnosticList diagnostics;
    const SourceMark mark = whole_file(campus_file);
    std::optional<CampusDescription> campus = open_campus(campus_file, mark, diagnostics);
    throw_in_order(diagnostics, mark);
    return std::move(*campus);
}

std::vector<engine::Step> load_steps(const fs::path& steps_file) {
    DiagnosticList diagnostics;
    std::vector<engine::Step> steps;
    const SourceMark mark = whole_file(steps_file);
    if (const auto file = YamlFile::open(steps_file, ".steps.yaml", mark, diagnostics)) {
        steps = read_steps_alone(file->root(), steps_file);
    }
    throw_in_order(diagnostics, mark);
    return steps;
}

AvatarProfile load_avatar(const fs::path& avatar_file) {
    DiagnosticList diagnostics;
    const SourceMark mark = whole_file(avatar_file);
    AvatarProfile profile = open_avatar(avatar_file, mark, diagnostics);
    throw_in_order(diagnostics, mark);
    return profile;
}

}  // namespace campuswalk::config
