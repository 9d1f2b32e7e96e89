#pragma once

#include <string>
#include <vector>

namespace campuswalk::tools {

/// What one of Slurm's programs printed, to standard output and standard error, and how it ended.
struct SlurmAnswer {
    int exit_code = 0;  ///< 127 if there is no such program
    std::string text;

    bool good() const { return exit_code == 0; }
};

/// `environment` are further variables, NAME=VALUE.
SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::vector<std::string>& environment = {});

}  // namespace campuswalk::tools
