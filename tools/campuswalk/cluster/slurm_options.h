#pragma once

#include <optional>
#include <string>
#include <vector>

namespace campuswalk::tools {

enum class SlurmMode {
    submit,  ///< and wait for the end
    script,  ///< only write the scripts
};

/// How work is handed to Slurm.
struct SlurmOptions {
    std::optional<SlurmMode> mode;  ///< nullopt: it isn't
    std::optional<int> shards;

    // sbatch's own, as written there.
    std::optional<std::string> partition;
    std::optional<std::string> account;
    std::optional<std::string> time;
    std::optional<std::string> mem;
    std::vector<std::string> sbatch;  ///< further options, as in "--qos=long"
};

}  // namespace campuswalk::tools
