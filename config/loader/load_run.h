#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/loader/overrides.h"
#include "config/loader/search_paths.h"
#include "engine/script/walk.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// What a walk's file name ends with.
inline constexpr std::string_view kWalkSuffix = ".walk.yaml";

/// A walk and the campus it names, which other walks may share, both read and checked as far as that is
/// possible without the models.
struct Run {
    engine::Walk walk;
    std::shared_ptr<const scene::CampusDescription> campus;
    std::vector<std::filesystem::path> profiles;  ///< files of the avatar and the light, if it names some
    std::vector<scene::Diagnostic> warnings;
};

/// By path, as diagnostics show it, and by project, on which it depends what a campus may name.
using CampusDescriptions =
    std::map<std::pair<std::string, std::string>, std::shared_ptr<const scene::CampusDescription>>;

/// Reads many walks, but each campus that they name only once.
class RunLoader {
public:
    explicit RunLoader(SearchPaths search) : search_(std::move(search)) {}

    /// Reads `NAME.walk.yaml`, the campus it names and its profiles; resolves places and spawns. The
    /// overrides replace some of the walk's values.
    Run load(const std::filesystem::path& walk_file, const Overrides& overrides = {});

    /// Checks the overrides, and the files they name, as far as that is possible without a walk.
    void check(const Overrides& overrides);

private:
    SearchPaths search_;
    CampusDescriptions campuses_;
};

/// Reads one walk alone.
inline Run load_run(const std::filesystem::path& walk_file, const SearchPaths& search) {
    return RunLoader(search).load(walk_file);
}

/// Reads `NAME.steps.yaml` and what it includes; without a walk the names of places can't be checked.
std::vector<engine::Step> load_steps(const std::filesystem::path& steps_file, const SearchPaths& search = {});

}  // namespace campuswalk::config
