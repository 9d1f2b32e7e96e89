#pragma once

namespace campuswalk::tools {

/// Call first. Keeps a file that the program opens from becoming its standard output when the caller closed
/// that, and turns a reader who went away into a failed write instead of a signal.
void guard_standard_streams();

/// Throws std::runtime_error when something printed so far could not be written.
void check_standard_output();

}  // namespace campuswalk::tools
