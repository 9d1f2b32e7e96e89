#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// The walk files that the paths stand for, sorted by their bytes and each once: a file stands for itself, a
/// folder for every `*.walk.yaml` in it and below. Hidden folders are skipped, and folders that have been
/// seen already, so that links may form a circle. Results are relative to the current folder. Throws
/// scene::InputError (folder-unreadable) for a folder that can't be looked into.
std::vector<std::filesystem::path> find_walks(const std::vector<std::filesystem::path>& paths);

/// The path as a user who stands in the current folder would write it, without `.` and `x/..`.
std::filesystem::path as_seen_from_here(const std::filesystem::path& path);

/// A name below the output folder for each of the files: its path without `.walk.yaml`, from the deepest
/// folder that holds all of them.
std::vector<std::string> output_names(const std::vector<std::filesystem::path>& files);

}  // namespace campuswalk::tools
