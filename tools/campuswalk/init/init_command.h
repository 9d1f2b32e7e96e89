#pragma once

#include <filesystem>

namespace campuswalk::tools {

enum class Template { minimal, stairs, campus };

struct InitOptions {
    std::filesystem::path folder = ".";
    Template which = Template::minimal;
};

/// Makes a folder with a campus, walks that pass and one that fails as it says, and a workflow that runs
/// them. Overwrites nothing: a folder with files in it is refused. Returns the exit code.
int make_project(const InitOptions& options);

}  // namespace campuswalk::tools
