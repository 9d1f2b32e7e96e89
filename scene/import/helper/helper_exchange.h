#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/import/helper/import_limits.h"

namespace campuswalk::scene {

/// A program that answers one request when it is started with these arguments (helper_streams.h).
struct HelperProgram {
    std::filesystem::path program;
    std::vector<std::string> arguments;  ///< without the program's name
};

/// What a helper wrote. Its bytes are as untrusted as the file that it read.
struct HelperResponse {
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;  ///< keeps the bytes
    std::string
        failure;  ///< why there are none, after "FILE can't be read: " or the like; empty if there are
};

/// What users can do about a failure.
struct HelperAdvice {
    const char* if_too_large = "re-export, simplify or split it";
    const char* if_unreadable = "convert it to glTF";
};

/// The limits for one file: with the CPU time for its size added.
ImportLimits limits_for(const std::filesystem::path& file, ImportLimits limits);

/// Starts the helper with the request as its standard input, and waits for its response. A helper that
/// crashes or exceeds a limit is a failure; one that can't be started, std::runtime_error.
HelperResponse ask_helper(const HelperProgram& helper, std::span<const std::byte> request,
                          const ImportLimits& limits, const HelperAdvice& advice = {});

}  // namespace campuswalk::scene
