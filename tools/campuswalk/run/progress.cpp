#include "tools/campuswalk/run/progress.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace campuswalk::tools {

namespace {

constexpr std::size_t kWidth = 30;  // characters

}  // namespace

Progress::Progress(bool wanted, std::size_t total) : wanted_(wanted), total_(total) {}

void Progress::count(bool good) {
    hide();
    ++done_;
    failed_ += good ? 0 : 1;
    walk_.clear();
}

void Progress::walk_is_at(std::string_view walk, std::string_view place) {
    hide();
    walk_.assign(walk).append(" at ").append(place);
    show();
}

void Progress::show() {
    const bool many = total_ > 1;
    if (!wanted_ || shown_ || done_ >= total_ || (!many && walk_.empty())) {
        return;
    }
    std::string line;
    if (many) {
        const std::size_t filled = std::min(kWidth, kWidth * done_ / total_);
        line = "[" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " +
               std::to_string(done_) + "/" + std::to_string(total_);
        line += failed_ > 0 ? ", " + std::to_string(failed_) + " failed" : "";
        line += walk_.empty() ? "" : ", ";
    }
    std::fputs((line + walk_).c_str(), stderr);
    std::fflush(stderr);
    shown_ = true;
}

void Progress::hide() {
    if (shown_) {
        std::fputs("\r\x1b[K", stderr);
        std::fflush(stderr);
        shown_ = false;
    }
}

}  // namespace campuswalk::tools
