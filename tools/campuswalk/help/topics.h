#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools::help {

struct Topic {
    std::string_view name;
    std::string_view description;
    std::string (*text)() = nullptr;
    Json (*json)() = nullptr;  ///< null if there is none
};

std::span<const Topic> topics();

}  // namespace campuswalk::tools::help
