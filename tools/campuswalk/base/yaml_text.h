#pragma once

#include <string>
#include <vector>

// Parts of the YAML files that the program writes. Words of others stay words.

namespace campuswalk::tools {

/// In quotes: JSON's strings are YAML's, too.
std::string yaml_string(const std::string& text);

/// One glob, or a list of them in lines that can be read, each indented by seven spaces.
std::string globs_yaml(const std::vector<std::string>& globs);

/// "  # text" for the end of a line, on one line whatever the text; empty if the text is.
std::string yaml_comment(const std::string& text);

}  // namespace campuswalk::tools
