#include "tools/campuswalk/run/frame_helpers.h"

#include <csignal>
#include <optional>
#include <stdexcept>
#include <utility>

namespace campuswalk::tools {

namespace {

/// Waits for it. Throws std::runtime_error when the process has ended.
Message next_message(Worker& helper) {
    while (true) {
        if (std::optional<Message> message = helper.next_message()) {
            return std::move(*message);
        }
        if (!helper.read()) {
            helper.forget_task();
            helper.hang_up();
            throw std::runtime_error("a process that drew frames is gone: " + helper.obituary());
        }
    }
}

}  // namespace

FrameHelpers::FrameHelpers(std::size_t parts, const Draw& draw) {
    for (std::size_t part = 1; part < parts; ++part) {
        const Work work = [&draw, part](std::size_t task, const Say& say) {
            // Ctrl-C is for the process that plays; this one ends with it.
            std::signal(SIGINT, SIG_IGN);
            std::signal(SIGTERM, SIG_IGN);
            draw(task, part, say);
        };
        helpers_.emplace_back(work, helpers_);
    }
}

void FrameHelpers::begin(std::size_t task) {
    for (Worker& helper : helpers_) {
        while (helper.place()) {
            if (next_message(helper).topic == Topic::result) {
                helper.forget_task();
            }
        }
        helper.give(task, task, std::nullopt);
    }
}

std::string FrameHelpers::next_frame(std::size_t part) {
    Worker& helper = helpers_.at(part - 1);
    if (!helper.place()) {
        throw std::runtime_error("a process that drew frames has ended its walk before this one");
    }
    Message message = next_message(helper);
    if (message.topic != Topic::frame) {
        helper.forget_task();
        throw std::runtime_error(message.body.empty() ? "a frame is missing" : message.body);
    }
    return std::move(message.body);
}

}  // namespace campuswalk::tools
