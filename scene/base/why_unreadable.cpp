#include "scene/base/why_unreadable.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace campuswalk::scene {

namespace fs = std::filesystem;

std::string why_unreadable(const fs::path& file) {
    const auto denied = [](const std::error_code& error) {
        return "it can't be read: " + error.message() + "; check its permissions";
    };
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) {
        return "no such file; check the path";
    }
    if (error) {
        return denied(error);
    }
    if (fs::is_directory(status)) {
        return "it is a folder; name a file";
    }
    if (!fs::is_regular_file(status)) {
        return "it is a pipe, a socket or a device; write what it gives to a file, and name that";
    }
    return std::ifstream(file).is_open() ? "" : denied({errno, std::generic_category()});
}

}  // namespace campuswalk::scene
