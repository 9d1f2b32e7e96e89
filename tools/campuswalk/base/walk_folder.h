#pragma once

#include <filesystem>
#include <functional>

namespace campuswalk::tools {

/// Calls `visit` for everything in a folder and below, which returns whether to look into what is a folder.
/// Links aren't followed. Only one folder is open at a time, so that no depth exhausts what a process may
/// open: what can't be looked at is an error, never left out. Throws scene::InputError (folder-unreadable)
/// with the folder's name.
void walk_folder(const std::filesystem::path& folder,
                 const std::function<bool(const std::filesystem::directory_entry& entry)>& visit);

}  // namespace campuswalk::tools
