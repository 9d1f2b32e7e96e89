#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace campuswalk::tools::bench {

/// A folder for files for other programs: the requested one, which stays, or else a temporary one, which is
/// removed by the destructor.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::filesystem::path& requested = {})
        : path_(requested), is_ours_(requested.empty()) {
        if (is_ours_) {
            path_ = std::filesystem::temp_directory_path() / ("campuswalk-bench-" + std::to_string(getpid()));
        }
        std::filesystem::create_directories(path_);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder() {
        if (is_ours_) {
            std::error_code ignored;
            std::filesystem::remove_all(path_, ignored);
        }
    }

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    bool is_ours_;
};

}  // namespace campuswalk::tools::bench
