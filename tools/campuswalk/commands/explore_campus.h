#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// Who walks everywhere if nobody is named.
inline constexpr const char* kUsualAvatar = "adult";

/// The option of the spawns, which errors are about.
inline constexpr const char* kFromOption = "--from";

/// Cells of 0.25 m that are explored, however long that takes: 3.75 km² of ground.
inline constexpr int kMostCells = 60'000'000;

/// How to explore a campus.
struct ExploreOptions {
    std::filesystem::path campus;
    std::string avatar = kUsualAvatar;           ///< as a walk says it
    std::vector<std::string> from;               ///< spawns; empty: all
    std::vector<std::string> allow;              ///< run, jump, crouch
    std::vector<std::string> disable;            ///< globs over objects
    std::vector<std::string> required;           ///< places, or "all"
    std::vector<std::string> fail_on;            ///< kinds of findings
    std::optional<std::filesystem::path> json;   ///< a file to write
    std::optional<std::filesystem::path> map;    ///< a folder for the storeys' plans
    std::optional<std::filesystem::path> walks;  ///< a folder for minimal walks
    std::optional<std::filesystem::path> geojson;
    std::vector<std::filesystem::path> covered_by;  ///< walks whose coverage is measured
    std::optional<double> fail_under;               ///< percent of the ground
    double min_width = 0.0;                         ///< metres
    int max_cells = kMostCells;
    std::optional<int> workers;
};

/// Throws scene::InputError if the campus can't be read, or an option names an avatar, a spawn or a place
/// that there isn't. Reads no models.
void check_exploration(const ExploreOptions& options);

/// Walks everywhere, prints the report and writes what the options ask for. Returns the exit code. `json`
/// becomes the report for programs, instead of the file, if it isn't null.
int explore_campus(const ExploreOptions& options, std::string* json);

}  // namespace campuswalk::tools
