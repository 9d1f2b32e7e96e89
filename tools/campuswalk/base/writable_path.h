#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools {

// Checked before a walk without touching anything, so that a run that is refused leaves no trace.
//
// A checkout may contain symbolic links, such as `out -> /etc`. Nothing is written through one: all functions
// here refuse a path that leads through a link below a folder that has `.git` or walks.config.yaml, below the
// current folder, or below `named`: the folder that the command line names for what is written. Nor is
// anything written into a pipe, a socket or a device, which a checkout may contain as well: opening one could
// take forever.

/// Whether the path leads through such a link: then it isn't what whoever wrote it on a command line knows.
bool leads_through_link(const std::filesystem::path& path);

/// Why a file can't be created or replaced here, including the folders it needs; empty when it can.
std::string why_file_unwritable(const std::filesystem::path& file, const std::filesystem::path& named = {});

/// The same for a folder and the files in it.
std::string why_folder_unwritable(const std::filesystem::path& folder,
                                  const std::filesystem::path& named = {});

/// Throw scene::InputError output-unwritable in these cases, with the reason after `message`. Of a folder,
/// nothing in it may be one of these either; without `named`, it is itself the one that is named.
void require_writable_file(const std::filesystem::path& file, const std::string& message,
                           const std::filesystem::path& named = {});
void require_writable_folder(const std::filesystem::path& folder, const std::string& message,
                             const std::filesystem::path& named = {});
/// Throws scene::InputError report-unwritable if `file` is one of `inputs`, under whatever name. `purpose`
/// completes "this would replace a file that …".
void require_no_input(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs,
                      const std::string& purpose);
/// Likewise for a picture, and file-name: a name with another ending than .png would lie about what is
/// written.
void require_writable_png(const std::filesystem::path& file, const std::string& message);

}  // namespace campuswalk::tools
