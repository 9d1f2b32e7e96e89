#include "tools/campuswalk/cluster/run_on_slurm.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "engine/report/result_json.h"
#include "scene/base/atomic_file.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/repository.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/cluster/job_scripts.h"
#include "tools/campuswalk/cluster/slurm_job.h"
#include "tools/campuswalk/cluster/submission.h"
#include "tools/campuswalk/run/output/job_folder.h"
#include "tools/campuswalk/run/output/output_folder.h"
#include "tools/campuswalk/run/plan/case_times.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/plan/run_settings.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/results/result_file.h"
#include "tools/campuswalk/run/results/run_key.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr int kUsualShards = 64;

void refuse(const char* option, const std::string& why) {
    throw error_about(option, "bad-value", why);
}

void check_options(const RunOptions& options, const RunSettings& settings) {
    if (options.watch) {
        refuse("--watch", "it can't be combined with --slurm");
    }
    if (options.last_failed) {
        refuse("--last-failed", "it can't be combined with --slurm; name the walks");
    }
    if (options.shard || options.shard_times || options.save) {
        refuse("--slurm", "it divides the run itself: leave out --shard, --shard-times and --save");
    }
    const bool logs =
        std::ranges::find(settings.reports, "log", &ReportTarget::name) != settings.reports.end();
    if (settings.single) {
        refuse("--slurm", "a run of one walk needs no cluster; name a folder");
    }
    if (options.jsonl || logs) {
        refuse("--slurm", "the logs of shards aren't merged; leave out --log, --jsonl and --reporter log");
    }
}

/// As far as they are known from the last runs in this output folder.
CaseTimes last_times(const fs::path& last_run, const JobFolder& folder) {
    CaseTimes times;
    std::error_code error;
    if (fs::is_regular_file(last_run, error)) {
        add_case_times(last_run, times);
    }
    for (fs::directory_iterator entry(folder.saved(), error), end; !error && entry != end;
         entry.increment(error)) {
        add_case_times(entry->path(), times);
    }
    return times;
}

/// Of the job that is to be continued.
std::optional<engine::RunPlan> planned_before(const JobFolder& folder) {
    std::error_code ignored;
    if (!fs::is_regular_file(folder.plan(), ignored)) {
        return std::nullopt;
    }
    const std::optional<ResultFile> header = ResultFile::open(folder.plan());
    return header ? std::optional(header->plan()) : std::nullopt;
}

class SlurmRun {
public:
    SlurmRun(const RunOptions& options, const SlurmOptions& slurm, std::vector<std::string> arguments)
        : options_(options),
          slurm_(slurm),
          arguments_(std::move(arguments)),
          settings_(resolve_settings(options, environment_variable)),
          folder_(job_folder(settings_.output)) {}

    int run() {
        check_options(options_, settings_);
        check_targets(settings_.reports);
        check_name_for_scripts(folder_.root);
        require_writable_folder(folder_.root, "the job's files can't be written here", settings_.output);
        const OutputFolder output(
            settings_.output, run_key(environment_variable),
            {.all = !settings_.ci, .temporaries = true, .paths = {folder_.root.filename()}});
        const std::vector<std::string> sbatch = sbatch_options(slurm_);
        refuse_if_busy(folder_);
        const engine::RunPlan plan = options_.resume ? planned_again() : planned();
        if (plan.all_cases == 0) {
            print_error_line("no walk is selected; see --list");
            return options_.pass_with_no_tests ? kPass : kNothingSelected;
        }
        clear_job(folder_);
        fs::create_directories(folder_.saved());
        scene::write_file_atomically(folder_.plan(),
                                     report_line(engine::to_header_line(plan), "", key_of_tasks()) + "\n");
        const ArrayJob job = array_job(plan, sbatch);
        write_scripts(job);
        if (slurm_.mode == SlurmMode::script) {
            print_submission(folder_);
            return kPass;
        }
        return submit_and_wait(job, {.what = scene::plural(plan.all_cases, "walk") + " in " +
                                             scene::plural(static_cast<std::size_t>(plan.shards), "shard"),
                                     .go_on = "the same command with --resume continues",
                                     .quiet = options_.quiet});
    }

private:
    /// Divides the run, and keeps what the shards need to divide it likewise.
    engine::RunPlan planned() {
        engine::RunPlan whole = summary(1);
        if (whole.all_cases == 0) {
            return whole;
        }
        const CaseTimes times = last_times(settings_.saved, folder_);
        for (const fs::path& part : {folder_.results(), folder_.saved()}) {
            fs::remove_all(part);
        }
        scene::write_file_atomically(folder_.times(), to_json_lines(times));
        const int parts =
            static_cast<int>(whole.all_cases) / options_.repeat_each;  // repetitions stay together
        return summary(std::min(slurm_.shards.value_or(kUsualShards), parts));
    }

    engine::RunPlan planned_again() {
        const std::optional<engine::RunPlan> before = planned_before(folder_);
        if (!before) {
            if (options_.resume == Resume::automatic) {
                return planned();
            }
            throw error_about(folder_.root, "missing-file",
                              "there is no job to continue; run without --resume first");
        }
        if (slurm_.shards && *slurm_.shards != before->shards) {
            refuse("--shards", "the job to continue has " + std::to_string(before->shards));
        }
        engine::RunPlan plan = summary(before->shards);
        if (plan.contents != before->contents || plan.division != before->division) {
            throw error_about(
                folder_.root, "other-run",
                "the last job ran different walks or files, so it can't be continued; run without "
                "--resume");
        }
        return plan;
    }

    Plan summarized(const RunSettings& settings) const {
        PlanOptions selection = plan_options(options_);
        selection.summary_only = true;
        return make_plan(settings, selection);
    }

    engine::RunPlan summary(int shards) const {
        RunSettings divided = settings_;
        divided.shard = Shard{0, shards, "--slurm", ""};
        if (shards > 1) {
            divided.shard_times = folder_.times();
        }
        const Plan plan = summarized(divided);
        require_walks(plan, settings_.min_cases);
        engine::RunPlan summary = plan.summary;
        summary.start = start_in_repository(environment_variable);
        return summary;
    }

    ArrayJob array_job(const engine::RunPlan& plan, const std::vector<std::string>& sbatch) const {
        ArrayJob job;
        job.folder = folder_;
        job.tasks = plan.shards;
        job.cpus = options_.workers.value_or(1);  // of a node that others use, too
        job.sbatch = sbatch;
        job.task = {this_program(),
                    "run",
                    "--quiet",
                    "--shard=\"$task\"/" + std::to_string(plan.shards),
                    "--workers=\"$cpus\"",
                    "--resume=auto",
                    "--shard-times=\"$folder\"/times.jsonl",
                    "--save=\"$folder\"/saved/\"$task\".jsonl",
                    "--reporter=jsonl=\"$folder\"/results/\"$task\".jsonl"};
        for (const std::string& record :
             settings_.records) {  // an html report needs one that nobody asked for
            if (std::ranges::find(options_.records, record) == options_.records.end()) {
                job.task.push_back("--record=" + record);
            }
        }
        for (const std::string& argument : arguments_) {
            job.task.push_back(shell_word(argument));
        }
        job.merge = merge_command();
        job.after_restart = "goes on where its saved results end";
        return job;
    }

    std::vector<std::string> merge_command() const {
        std::vector<std::string> words = {this_program(), "merge-reports", "\"$folder\"", "--slurm=\"$job\"",
                                          shell_word("--output=" + settings_.output.generic_string())};
        for (const ReportTarget& target : settings_.reports) {
            words.push_back(shell_word("--reporter=" + target.name +
                                       (target.file ? "=" + target.file->generic_string() : "")));
        }
        if (options_.quiet) {
            words.emplace_back("--quiet");
        }
        words.push_back(std::string("--color=") + (settings_.color ? "always" : "never"));
        return words;
    }

    const RunOptions& options_;
    const SlurmOptions& slurm_;
    std::vector<std::string> arguments_;
    RunSettings settings_;
    JobFolder folder_;
};

}  // namespace

const std::vector<std::string>& options_of_submission() {
    static const std::vector<std::string> names = {
        "--slurm",  "--shards",  "--partition", "--account",  "--time",  "--mem",
        "--sbatch", "--shard",   "--resume",    "--reporter", "--quiet", "--verbose",
        "--color",  "--workers", "--log",       "--jsonl",    "--save",  "--shard-times"};
    return names;
}

int run_on_slurm(const RunOptions& options, const SlurmOptions& slurm,
                 const std::vector<std::string>& arguments) {
    return SlurmRun(options, slurm, arguments).run();
}

}  // namespace campuswalk::tools
