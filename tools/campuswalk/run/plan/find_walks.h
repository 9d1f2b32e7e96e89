#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// The walk files of the paths, sorted by their bytes and each once: the files themselves, and every
/// `*.walk.yaml` in and below the folders. Skips hidden folders, and folders that it has visited, so that
/// links may form a cycle. Results are relative to the current folder. Throws scene::InputError
/// (folder-unreadable) for a folder that can't be read.
std::vector<std::filesystem::path> find_walks(const std::vector<std::filesystem::path>& paths);

/// The path as a user in the current folder would write it, without `.` and `x/..`.
std::filesystem::path as_seen_from_here(const std::filesystem::path& path);

/// A name below the output folder for each of the files: its path without `.walk.yaml`, from the deepest
/// folder that holds all of them, as engine::to_artifact_path() writes it.
std::vector<std::string> output_names(const std::vector<std::filesystem::path>& files);

}  // namespace campuswalk::tools
