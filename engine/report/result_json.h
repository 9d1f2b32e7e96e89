#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// A result as one line of JSON, without the line's end: what the jsonl report contains, workers send, and
/// merge-reports and --resume read. Always has every field (see result_fields.h); numbers keep all bits.
/// Bytes that aren't UTF-8 can't be written in JSON and become U+FFFD.
std::string to_json_line(const WalkResult& result);

/// The inverse. Throws std::runtime_error, saying what is wrong, for any other line: a field is missing,
/// unknown, repeated or of another type, or a number is out of range.
WalkResult result_from_json_line(std::string_view line);

/// The first line of a jsonl report, with the planned number of cases.
std::string results_header(std::size_t cases);

/// The number of cases in such a line; none for any other line.
std::optional<std::size_t> cases_of_header(std::string_view line);

}  // namespace campuswalk::engine
