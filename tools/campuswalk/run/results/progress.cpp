#include "tools/campuswalk/run/results/progress.h"

#include <algorithm>

#include "engine/events/decimals.h"
#include "scene/base/printable.h"

namespace campuswalk::tools {

namespace {

constexpr std::size_t kWidth = 30;  // characters

}  // namespace

std::string progress_bar(double share) {
    const auto filled = static_cast<std::size_t>(kWidth * std::clamp(share, 0.0, 1.0));
    return "[" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] ";
}

Progress::Progress(bool enabled, std::size_t total) : status_(enabled), total_(total) {}

void Progress::count(bool good) {
    hide();
    ++done_;
    failed_ += good ? 0 : 1;
    walk_.clear();
}

void Progress::walk_is_at(std::string_view walk, double seconds, std::optional<double> planned) {
    hide();
    walk_.assign(scene::printable(walk)).append(" at ").append(engine::fixed(seconds, 1));
    // The walk may be behind its plan, and then nobody knows how long it will still take.
    const bool known = planned && *planned > 0.0 && seconds <= *planned;
    walk_ += known ? " of " + engine::fixed(*planned, 1) + " s" : " s";
    share_ = known ? std::optional(seconds / *planned) : std::nullopt;
    show();
}

std::string Progress::line() const {
    if (total_ == 1) {
        return (share_ ? progress_bar(*share_) : "") + walk_;
    }
    return progress_bar(static_cast<double>(done_) / static_cast<double>(total_)) + std::to_string(done_) +
           "/" + std::to_string(total_) + (failed_ > 0 ? ", " + std::to_string(failed_) + " failed" : "") +
           (walk_.empty() ? "" : ", ") + walk_;
}

void Progress::show() {
    if (!status_.is_shown() && done_ < total_ && (total_ > 1 || !walk_.empty())) {
        status_.show(line());
    }
}

}  // namespace campuswalk::tools
