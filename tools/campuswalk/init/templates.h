#pragma once

#include <string>
#include <vector>

#include "tools/campuswalk/init/school.h"

namespace campuswalk::tools::init {

struct NewFile {
    std::string path;  ///< below the new folder
    std::string text;
};

/// Of `none`: no file.
std::vector<NewFile> files_of(Template which);

}  // namespace campuswalk::tools::init
