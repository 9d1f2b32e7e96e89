#pragma once

#include <stdexcept>

namespace campuswalk::tools {

/// Call this first. Keeps a file that the program opens from becoming its standard output when the caller has
/// closed that, and makes writing to a closed pipe fail instead of raising a signal.
void guard_standard_streams();

/// Nobody reads standard output any more, as after `| head`: whoever went away needs no message.
struct NoReader : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws std::runtime_error when something printed so far could not be written; NoReader if that is why.
void check_standard_output();

}  // namespace campuswalk::tools
