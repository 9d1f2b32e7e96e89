#include "tools/campuswalk/run/workers/frame_helpers.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <stdexcept>
#include <utility>

namespace campuswalk::tools {

namespace {

/// Ctrl-C is for the process that plays, and what libraries say on standard error it hears from them itself.
void stay_in_the_background() {
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
        dup2(nowhere, STDERR_FILENO);
        close(nowhere);
    }
}

}  // namespace

FrameHelpers::FrameHelpers(std::size_t parts, const Draw& draw) {
    for (std::size_t part = 1; part < parts; ++part) {
        const Work work = [&draw](std::size_t its_part, const Say& say) {
            stay_in_the_background();
            draw(its_part, say);
        };
        helpers_.emplace_back(work, helpers_);
    }
    for (std::size_t part = 1; part < parts; ++part) {
        helpers_[part - 1].give(part, part, std::nullopt);
    }
}

std::string FrameHelpers::next_frame(std::size_t part) {
    Worker& helper = helpers_.at(part - 1);
    if (!helper.place()) {
        throw std::runtime_error("a process that drew frames has ended before this one");
    }
    Message message = helper.wait_for_message("drew frames");
    if (message.topic != Topic::frame) {
        helper.forget_task();
        throw std::runtime_error(message.body.empty() ? "a frame is missing" : message.body);
    }
    return std::move(message.body);
}

}  // namespace campuswalk::tools
