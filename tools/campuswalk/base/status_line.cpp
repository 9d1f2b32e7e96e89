#include "tools/campuswalk/base/status_line.h"

#include <cstdio>

namespace campuswalk::tools {

void StatusLine::show(const std::string& text) {
    if (!enabled_) {
        return;
    }
    hide();
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
    shown_ = true;
}

void StatusLine::hide() {
    if (shown_) {
        std::fputs("\r\x1b[K", stderr);
        std::fflush(stderr);
        shown_ = false;
    }
}

}  // namespace campuswalk::tools
