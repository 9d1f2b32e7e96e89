#include "tools/campuswalk/run/cases/frame_helpers.h"

#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <utility>

namespace campuswalk::tools {

namespace {

/// Ignores Ctrl-C, which the process that plays handles, and discards messages of libraries, which that
/// process prints itself.
void detach_from_terminal() {
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    if (const scene::Descriptor null_device = scene::open_null_device(); null_device.open()) {
        dup2(null_device.number(), STDERR_FILENO);
    }
}

}  // namespace

FrameHelpers::FrameHelpers(std::size_t parts, const Draw& draw) {
    const StartWork start = [&draw] {
        detach_from_terminal();
        return draw;
    };
    for (std::size_t part = 1; part < parts; ++part) {
        helpers_.emplace_back(start, helpers_);
    }
    for (std::size_t part = 1; part < parts; ++part) {
        helpers_[part - 1].give(part);
    }
}

std::string FrameHelpers::next_frame(std::size_t part) {
    Worker& helper = helpers_.at(part - 1);
    if (!helper.task()) {
        throw std::runtime_error("a process that drew frames has ended before this one");
    }
    Message message = helper.wait_for_message("drew frames");
    if (message.topic != Topic::frame) {
        throw std::runtime_error(message.body.empty() ? "a frame is missing" : message.body);
    }
    return std::move(message.body);
}

}  // namespace campuswalk::tools
