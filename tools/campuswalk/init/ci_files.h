#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "tools/campuswalk/init/templates.h"

namespace campuswalk::tools::init {

/// What runs the walks for every change.
enum class Service { github, gitlab, none };

/// Where a service gets campuswalk from.
struct Publication {
    std::string repository;  ///< OWNER/NAME on GitHub, with the action and the releases; empty if unknown
    std::string commit;      ///< of this version there, 40 digits; empty if unknown
    std::string version;
};

/// That of this build.
Publication publication();

/// The service's file, for a project of so many walks; nullopt if there is no service. Actions are named by
/// their commit, a package by its release and hash. What isn't known here, a hash always, has an empty line
/// in the file, without which its job ends with an error: a file is the only place that pull requests from
/// forks see, too.
std::optional<NewFile> ci_file(Service service, const Publication& from, std::size_t walks);

}  // namespace campuswalk::tools::init
