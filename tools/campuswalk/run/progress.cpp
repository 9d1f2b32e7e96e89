#include "tools/campuswalk/run/progress.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace campuswalk::tools {

namespace {

constexpr std::size_t kWidth = 30;  // characters

}  // namespace

Progress::Progress(bool wanted, std::size_t total) : wanted_(wanted && total > 1), total_(total) {}

void Progress::count(bool good) {
    hide();
    ++done_;
    failed_ += good ? 0 : 1;
}

void Progress::show() {
    if (!wanted_ || shown_ || done_ >= total_) {
        return;
    }
    const std::size_t filled = std::min(kWidth, kWidth * done_ / total_);
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "[%s] %zu/%zu", bar.c_str(), done_, total_);
    if (failed_ > 0) {
        std::fprintf(stderr, ", %zu failed", failed_);
    }
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
