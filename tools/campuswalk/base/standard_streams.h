#pragma once

namespace campuswalk::tools {

/// Call this first. Keeps a file that the program opens from becoming its standard output when the caller has
/// closed that, and makes writing to a closed pipe fail instead of raising a signal.
void guard_standard_streams();

/// Throws std::runtime_error when something printed so far could not be written.
void check_standard_output();

}  // namespace campuswalk::tools
