#pragma once

#include <filesystem>

namespace campuswalk::scene {

/// PREFIX/share/campuswalk of the running program at PREFIX/bin/NAME: its profiles, the demo, and in archives
/// the fonts. Found from the program's own place, so that an installation can be moved. Need not exist: a
/// program that isn't installed has none.
std::filesystem::path installed_data();

}  // namespace campuswalk::scene
