#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/report/run_plan.h"
#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// A result as one line of JSON, without the line's end: what the jsonl report contains, workers send, and
/// merge-reports and --resume read. Always has every field (see result_fields.h); numbers keep all bits.
/// Bytes that aren't UTF-8 can't be written in JSON and become U+FFFD.
std::string to_json_line(const WalkResult& result);

/// The inverse. Throws std::runtime_error, saying what is wrong, for any other line: a field is missing,
/// unknown, repeated or of another type, or a number is out of range.
WalkResult result_from_json_line(std::string_view line);

/// As in a json report.
std::string to_json(const RunPlan& plan);

/// The first line of a jsonl report, without the line's end.
std::string to_header_line(const RunPlan& plan);

/// The inverse; nullopt for lines of other files. Throws std::runtime_error, saying what is wrong, for a
/// header that isn't as above, such as another version's.
std::optional<RunPlan> plan_from_header_line(std::string_view line);

}  // namespace campuswalk::engine
