#pragma once

#include <cstdlib>
#include <functional>
#include <optional>
#include <string>

namespace campuswalk::tools {

/// The value of a variable; nullopt if it is unset or empty.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// That of this process.
inline std::optional<std::string> environment_variable(const std::string& name) {
    const char* value = std::getenv(name.c_str());
    return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
}

/// Whether a CI machine plays what anybody may have written. Azure Pipelines sets only a variable of its own.
inline bool is_ci(const Environment& environment) {
    const std::string ci = environment("CI").value_or(environment("TF_BUILD").value_or("false"));
    return ci != "false" && ci != "False" && ci != "0";
}

}  // namespace campuswalk::tools
