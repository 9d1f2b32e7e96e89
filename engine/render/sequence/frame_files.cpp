#include "engine/render/sequence/frame_files.h"

#include <array>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/render/image/png.h"

namespace campuswalk::engine::render {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPrefix = "frame-";

bool is_frame(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with(kPrefix) && name.ends_with(".png") &&
           name.find_first_not_of("0123456789", 6) == name.size() - 4;
}

}  // namespace

FrameFiles::FrameFiles(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::vector<fs::path> old;
    for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
        if (is_frame(at->path())) {
            old.push_back(at->path());
        }
    }
    for (const fs::path& file : old) {
        fs::remove(file, error);
    }
}

void FrameFiles::add(const Frame& frame) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%05zu.png", frame.number + 1);
    write_png(frame.image, folder_ / (std::string(kPrefix) + number.data()));
}

}  // namespace campuswalk::engine::render
