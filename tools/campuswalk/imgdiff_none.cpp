#include <stdexcept>

#include "tools/campuswalk/imgdiff_command.h"

namespace campuswalk::tools {

int compare_image_files(const ImgdiffOptions&) {
    throw std::runtime_error("this build reads no pictures: configure with CAMPUSWALK_RENDER=ON");
}

}  // namespace campuswalk::tools
