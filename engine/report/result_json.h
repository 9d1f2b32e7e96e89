#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// A result as one line of JSON, without the line's end: what the jsonl report holds, what workers send and
/// what merge-reports and --resume read. Always every field (see result_fields.h); numbers keep their bits.
/// Bytes that are no UTF-8 can't be said in JSON and become U+FFFD.
std::string to_json_line(const WalkResult& result);

/// The inverse. Throws std::runtime_error, with what is wrong, when it is no such line: a field too few, one
/// too many or twice, another type, a number that doesn't fit.
WalkResult result_from_json_line(std::string_view line);

/// The first line of a jsonl report: how many cases the run was planned to have.
std::string results_header(std::size_t cases);

/// The cases that such a line tells; none when it is no such line.
std::optional<std::size_t> cases_of_header(std::string_view line);

}  // namespace campuswalk::engine
