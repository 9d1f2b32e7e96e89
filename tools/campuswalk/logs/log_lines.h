#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "engine/events/event.h"

namespace campuswalk::tools {

// The JSON lines of a walk's log (engine::JsonLines), read back.

/// Whether the line is the header of a walk's log.
bool is_log_header(std::string_view line);

/// What a header says about the walk.
struct LogHeader {
    std::string walk;
    std::string project;
    std::optional<double> timeout;  ///< simulated seconds
};
std::optional<LogHeader> log_header(std::string_view line);

/// What is used of an event's line.
struct LoggedEvent {
    engine::Tick tick = 0;
    double time = 0.0;  ///< seconds
    std::string kind;
    std::optional<Eigen::Vector3d> position;  ///< none, too, if it is farther off than any walk gets
    std::string hash;                         ///< of walk.end
};
std::optional<LoggedEvent> logged_event(std::string_view line);

/// The line as the text log prints it; unchanged if it isn't an event's.
std::string as_text_line(std::string_view line);

/// How two lines of logs that should be the same differ: "pos is 1,0,2 instead of 1,0,3" or, for different
/// events, "EVENT instead of EVENT". Nullopt for lines with the same content, however it is spelled.
std::optional<std::string> difference(std::string_view expected, std::string_view found);

/// Where two logs diverge: the first line, from 0, that differs or that one of them lacks. Lines with the
/// same content are equal, however it is spelled.
std::optional<std::size_t> first_divergence(std::span<const std::string> a, std::span<const std::string> b);

}  // namespace campuswalk::tools
