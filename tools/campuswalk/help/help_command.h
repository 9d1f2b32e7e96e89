#pragma once

#include <string>

namespace campuswalk::tools {

/// Prints what there is to say about a topic, or which topics there are when it is empty. Returns the exit
/// code: an unknown topic is bad usage.
int print_help(const std::string& topic);

}  // namespace campuswalk::tools
