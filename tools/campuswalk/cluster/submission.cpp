#include "tools/campuswalk/cluster/submission.h"

#include <filesystem>
#include <span>
#include <system_error>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/cache/content_hash.h"
#include "tools/campuswalk/base/environment.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/log_output.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/cluster/slurm_job.h"
#include "tools/campuswalk/run/results/run_key.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// Machines that continue each other's shards need the same key. It isn't written into a script.
std::vector<std::string> shared_key() {
    const std::optional<std::string> key = key_of_tasks();
    return shared_run_key(environment_variable) || !key
               ? std::vector<std::string>()
               : std::vector<std::string>{"CAMPUSWALK_RUN_KEY=" + *key};
}

/// What the merge has printed, as if this process had.
void show_merge(const JobFolder& folder) {
    std::error_code ignored;
    if (fs::exists(folder.merge_output(), ignored)) {
        LogOutput output(true, std::nullopt);
        output.write(read_bytes(folder.merge_output()));
        output.flush();
    }
    if (fs::exists(folder.merge_errors(), ignored)) {
        for (const std::string& line : read_lines(folder.merge_errors())) {
            print_error_line(line);
        }
    }
}

}  // namespace

std::string this_program() {
    std::error_code ignored;
    return shell_word(fs::read_symlink("/proc/self/exe", ignored).string());
}

void refuse_if_busy(const JobFolder& folder) {
    const std::optional<SlurmJob> earlier = noted_job(folder);
    if (!earlier) {
        return;
    }
    const QueueState queue = ask_queue(*earlier);
    if (queue.waiting + queue.running > 0 || queue.merging) {
        throw error_about(folder.root, "job-unfinished",
                          "job " + earlier->array +
                              " still uses this folder; wait for it, or end it with: scancel " +
                              earlier->array + " " + earlier->merge);
    }
}

std::optional<std::string> key_of_tasks() {
    if (const std::optional<std::string> shared = shared_run_key(environment_variable)) {
        return shared;
    }
    const std::string own = run_key(environment_variable);
    const std::string purpose = "slurm";
    return own.empty() ? std::nullopt
                       : std::optional(to_string(scene::keyed_hash_of(std::as_bytes(std::span(purpose)),
                                                                      std::as_bytes(std::span(own)))));
}

void clear_job(const JobFolder& folder) {
    for (const fs::path& part : {folder.ended(), folder.logs(), folder.merged(), folder.merge_output(),
                                 folder.merge_errors(), folder.job()}) {
        fs::remove_all(part);
    }
    for (const fs::path& part : {folder.results(), folder.ended(), folder.logs()}) {
        fs::create_directories(part);
    }
}

void print_submission(const JobFolder& folder) {
    print_line("job=$(sbatch --parsable %s)", shell_word(folder.shard_script().generic_string()).c_str());
    print_line("sbatch --dependency=afterany:\"$job\" %s \"$job\"",
               shell_word(folder.merge_script().generic_string()).c_str());
}

int submit_and_wait(const ArrayJob& array, const SubmissionStyle& style) {
    watch_for_interrupts();
    const SlurmJob job = submit(array.folder, shared_key());
    if (!style.quiet) {
        print_error_line("job " + job.array + ": " + style.what + "; job " + job.merge +
                         " merges the reports");
    }
    std::optional<int> code;
    try {
        code = wait_for_merge(array.folder, job, array.tasks, style.quiet);
    } catch (const Interrupted&) {
        cancel(job);
        print_error_line("interrupted: jobs " + job.array + " and " + job.merge + " are cancelled; " +
                         style.go_on);
        return kInterrupted;
    }
    if (!code) {
        print_error_line(scene::to_string(
            {scene::Severity::error,
             {"job " + job.merge, 0, 0},
             "task-lost",
             "the job that merges the reports didn't come to its end; run: bash " +
                 shell_word(array.folder.merge_script().generic_string()) + " " + job.array}));
        return kRunFailed;
    }
    show_merge(array.folder);
    return *code;
}

}  // namespace campuswalk::tools
