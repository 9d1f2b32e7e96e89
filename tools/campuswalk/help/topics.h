#pragma once

#include <span>
#include <string>
#include <string_view>

namespace campuswalk::tools::help {

struct Topic {
    std::string_view name;
    std::string_view description;
    std::string (*text)() = nullptr;
};

std::span<const Topic> topics();

}  // namespace campuswalk::tools::help
