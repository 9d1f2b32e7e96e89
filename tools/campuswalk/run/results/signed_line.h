#pragma once

#include <string>
#include <string_view>

namespace campuswalk::tools {

// Lines of JSON objects that prove who wrote them: the object begins with a code that only somebody with the
// key can compute from the context and the rest of the line. `context` is what the line belongs to, such as a
// run's fingerprint, so that a line can't be moved elsewhere.

/// The object, on one line, with its code. With an empty key the code proves nothing.
std::string signed_line(std::string_view object, std::string_view context, std::string_view key);

/// Whether a line begins with a code.
bool has_signature(std::string_view line);

/// The object without its code, as it was written. Throws std::runtime_error for a line that has none.
std::string unsigned_line(std::string_view line);

/// Whether the line was signed with this key, in this context. Never with an empty key.
bool is_authentic(std::string_view line, std::string_view context, std::string_view key);

}  // namespace campuswalk::tools
