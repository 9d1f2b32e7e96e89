#include "tools/campuswalk/cluster/job_scripts.h"

#include <algorithm>
#include <string_view>

#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

// A walk that brings its task down brings it down again.
constexpr int kMostRestarts = 3;

bool has_control_character(std::string_view text) {
    return std::ranges::any_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

std::string directive(const std::string& option) {
    return "#SBATCH " + option + "\n";
}

std::string quoted_directive(const std::string& name, const fs::path& file) {
    return directive(name + "=\"" + file.generic_string() + "\"");
}

std::string common_directives(const ArrayJob& job) {
    std::string text;
    for (const std::string& option : job.sbatch) {
        text += directive(option);
    }
    return text;
}

/// A file with the exit code appears whole.
std::string write_code(const std::string& file) {
    return "echo \"$code\" >" + file + ".part && mv " + file + ".part " + file + "\n";
}

}  // namespace

std::vector<std::string> sbatch_options(const SlurmOptions& options) {
    std::vector<std::string> words;
    const auto add = [&](const char* name, const std::optional<std::string>& value) {
        if (value) {
            words.push_back(std::string("--") + name + "=" + *value);
        }
    };
    add("partition", options.partition);
    add("account", options.account);
    add("time", options.time);
    add("mem", options.mem);
    for (const std::string& option : options.sbatch) {
        if (!option.starts_with('-')) {
            throw error_about("--sbatch", "bad-value",
                              "'" + option + "' must be an option of sbatch, as in --sbatch=--qos=long");
        }
        words.push_back(option);
    }
    for (const std::string& word : words) {
        if (has_control_character(word)) {
            throw error_about("--slurm", "bad-value", "an option of sbatch must be one line");
        }
    }
    return words;
}

void check_name_for_scripts(const fs::path& folder) {
    const std::string name = folder.generic_string();
    if (has_control_character(name) || name.find_first_of("\"'\\%#") != std::string::npos) {
        throw error_about(
            folder, "bad-value",
            "sbatch can't write to a folder with a quote, a backslash, % or # in its name; choose another "
            "--output");
    }
}

std::string shard_script(const ArrayJob& job) {
    return "#!/bin/bash\n" + directive("--job-name=campuswalk") +
           directive("--array=1-" + std::to_string(job.tasks)) + directive("--requeue") +
           directive("--open-mode=append") + directive("--cpus-per-task=" + std::to_string(job.cpus)) +
           quoted_directive("--output", job.folder.logs() / "%a.txt") + common_directives(job) +
           "# A node that dies: Slurm starts the task again, and it " + job.after_restart +
           ".\nfolder=" + shell_word(job.folder.root.generic_string()) +
           "\n"
           "task=$SLURM_ARRAY_TASK_ID\n"
           "cpus=${SLURM_CPUS_PER_TASK:-1}\n"
           "rm -f \"$folder/ended/$task\"\n"
           "code=0\n" +
           joined(job.task, " ") +
           " || code=$?\n"
           "# Killed, for instance because memory ran out: another start, as after the end of a node.\n"
           "if [ \"$code\" -ge 128 ] && [ \"$code\" -ne 130 ] && [ \"${SLURM_RESTART_COUNT:-0}\" -lt " +
           std::to_string(kMostRestarts) +
           " ]; then\n"
           "    scontrol requeue \"${SLURM_ARRAY_JOB_ID}_$task\" && sleep 300  # Slurm ends this script\n"
           "fi\n" +
           "if [ \"$code\" -lt 128 ]; then\n    " + write_code("\"$folder/ended/$task\"") +
           "fi\nexit \"$code\"\n";
}

std::string merge_script(const ArrayJob& job) {
    return "#!/bin/bash\n" + directive("--job-name=campuswalk-merge") + directive("--requeue") +
           quoted_directive("--output", job.folder.merge_output()) +
           quoted_directive("--error", job.folder.merge_errors()) + common_directives(job) +
           "folder=" + shell_word(job.folder.root.generic_string()) +
           "\n"
           "job=${1:?the number of the array job}\n"
           "code=0\n" +
           joined(job.merge, " ") + " || code=$?\n" + write_code("\"$folder/merged\"") + "exit \"$code\"\n";
}

}  // namespace campuswalk::tools
