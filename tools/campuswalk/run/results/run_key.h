#pragma once

#include <optional>
#include <string>

#include "tools/campuswalk/base/environment.h"

namespace campuswalk::tools {

/// The secret that marks results as this machine's own, so that a checkout can't bring results of its own
/// making: CAMPUSWALK_RUN_KEY, which machines that continue each other's runs share, or else
/// `campuswalk/run.key` in XDG_STATE_HOME (~/.local/state), which is made the first time. Empty if there is
/// no such folder, or if it is in a checkout. Throws scene::InputError (bad-value) for a variable that is too
/// short to be a secret.
std::string run_key(const Environment& environment);

/// Only the one that machines share: whoever merges the reports of several can check none but that. nullopt
/// if the variable is unset or empty, as a secret that a fork's pipeline doesn't get.
std::optional<std::string> shared_run_key(const Environment& environment);

}  // namespace campuswalk::tools
