#pragma once

#include <optional>
#include <string>

#include "tools/campuswalk/init/templates.h"

namespace campuswalk::tools::init {

/// What runs the walks for every change.
enum class Service { github, gitlab, none };

/// Its file; nullopt if there is no service. Whatever of others runs there is named by a version that can't
/// change, as far as the service knows such: actions by their commit, packages by release.
std::optional<NewFile> ci_file(Service service);

}  // namespace campuswalk::tools::init
