#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "engine/events/event.h"

namespace campuswalk::tools {

// The JSON lines of a walk's log (engine::JsonLines), read back.

/// Whether the line begins a walk's log.
bool is_log_header(std::string_view line);

/// What a header tells of the walk.
struct LogHeader {
    std::string walk;
    std::string project;
    std::optional<double> timeout;  ///< simulated seconds
};
std::optional<LogHeader> log_header(std::string_view line);

/// An event's line as far as it can be read.
struct LoggedEvent {
    engine::Tick tick = 0;
    double time = 0.0;  ///< seconds
    std::string kind;
    std::optional<Eigen::Vector3d> position;
    std::string hash;  ///< of walk.end
};
std::optional<LoggedEvent> logged_event(std::string_view line);

/// The line as the text log prints it; as it is where it's none of ours.
std::string as_text_line(std::string_view line);

/// How two lines of logs that should be the same differ: "pos is 1,0,2 instead of 1,0,3" or, for other
/// events, "EVENT instead of EVENT". Lines that tell the same in another spelling don't differ: nothing.
std::optional<std::string> difference(std::string_view expected, std::string_view found);

/// Where two logs part: the first line, from 0, that differs or that one of them lacks. Lines that tell the
/// same in another spelling are equal.
std::optional<std::size_t> first_divergence(std::span<const std::string> a, std::span<const std::string> b);

}  // namespace campuswalk::tools
