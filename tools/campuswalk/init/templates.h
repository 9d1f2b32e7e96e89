#pragma once

#include <string>
#include <vector>

#include "tools/campuswalk/init/school.h"

namespace campuswalk::tools::init {

inline constexpr const char* kGitIgnore = ".gitignore";
inline constexpr const char* kSchemaFolder = "schema/";

struct NewFile {
    std::string path;  ///< below the new folder
    std::string text;
};

/// Of `none`: no file.
std::vector<NewFile> files_of(Template which);

/// What a project needs besides a campus and walks: settings, schemas and what git is to ignore.
std::vector<NewFile> settings_files();

}  // namespace campuswalk::tools::init
