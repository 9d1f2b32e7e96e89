#include "tools/campuswalk/cluster/explore_on_slurm.h"

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include "scene/base/atomic_file.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/cluster/job_scripts.h"
#include "tools/campuswalk/cluster/slurm_job.h"
#include "tools/campuswalk/cluster/submission.h"
#include "tools/campuswalk/cluster/task_verdicts.h"
#include "tools/campuswalk/run/output/job_folder.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// Writes the JSON of several explorations, of which it holds one at a time.
class ExplorationsFile {
public:
    explicit ExplorationsFile(const std::optional<fs::path>& file) {
        if (file) {
            file_ = std::make_unique<scene::AtomicFile>(*file);
            write("{\"campuswalk_explorations\":1,\n\"explorations\":[");
        }
    }

    /// `report` is empty if there is none.
    void add(const Exploration& each, std::optional<int> exit_code, std::string_view report) {
        if (file_) {
            const Json head = {{"campus", each.campus.generic_string()},
                               {"avatar", each.avatar},
                               {"exit_code", exit_code ? Json(*exit_code) : Json()}};
            std::string text = json_text(head);
            text.pop_back();
            write(between_ + text + ",\"report\":" + (report.empty() ? "null" : std::string(report)) + "}");
            between_ = ",\n";
        }
    }

    void finish() {
        if (file_) {
            write("\n]}\n");
            file_->finish();
        }
    }

private:
    void write(std::string_view text) { file_->write(std::as_bytes(std::span(text))); }

    std::unique_ptr<scene::AtomicFile> file_;
    std::string between_ = "\n";
};

JobFolder folder_of(const ExplorationRequest& request) {
    return {request.output / "slurm-explore"};
}

fs::path task_file(const JobFolder& folder, int task, const char* ending) {
    return folder.results() / (std::to_string(task) + ending);
}

void print_heading(const Exploration& each) {
    print_line("=== %s, avatar %s", each.campus.generic_string().c_str(), each.avatar.c_str());
}

/// Errors while running take precedence over bad input, and that over what was found.
int worse(int a, int b) {
    const std::vector<int> order = {kPass, kExpectationFailed, kBadInput, kRunFailed, kInterrupted};
    return std::ranges::find(order, a) < std::ranges::find(order, b) ? b : a;
}

/// A report that is JSON, or nothing.
std::string whole_report(const fs::path& file) {
    std::error_code ignored;
    std::string text = fs::is_regular_file(file, ignored) ? read_bytes(file) : "";
    return Json::accept(text) ? text : "";
}

ArrayJob array_job(const ExplorationRequest& request, const std::vector<std::string>& sbatch,
                   const std::vector<std::string>& arguments) {
    ArrayJob job;
    job.folder = folder_of(request);
    job.tasks = static_cast<int>(request.all.size());
    job.cpus = request.cpus;
    job.sbatch = sbatch;
    job.after_restart = "explores from the beginning";
    job.task = {this_program(), "explore", "--only=\"$task\"", "--workers=\"$cpus\"",
                "--json=\"$folder\"/results/\"$task\".json"};
    job.merge = {this_program(), "explore", "--merge=\"$job\"",
                 shell_word("--output=" + request.output.generic_string())};
    if (request.json) {
        job.merge.push_back(shell_word("--json=" + request.json->generic_string()));
    }
    for (const std::string& argument : arguments) {
        job.task.push_back(shell_word(argument));
        job.merge.push_back(shell_word(argument));
    }
    job.task.emplace_back(">\"$folder\"/results/\"$task\".txt");
    return job;
}

}  // namespace

std::vector<Exploration> explorations_of(const std::vector<fs::path>& campuses,
                                         const std::vector<std::string>& avatars) {
    std::vector<Exploration> all;
    for (const fs::path& campus : campuses) {
        for (const std::string& avatar : avatars) {
            all.push_back({campus, avatar});
        }
    }
    return all;
}

int explore_all(const ExplorationRequest& request, const Explore& explore) {
    ExplorationsFile file(request.json);
    int worst = kPass;
    for (const Exploration& each : request.all) {
        print_heading(each);
        std::string json;
        const int code = explore(each, json);
        file.add(each, code, json);
        worst = worse(worst, code);
    }
    file.finish();
    return worst;
}

int explore_on_slurm(const ExplorationRequest& request, const SlurmOptions& slurm,
                     const std::vector<std::string>& arguments) {
    const JobFolder folder = folder_of(request);
    check_name_for_scripts(folder.root);
    require_writable_folder(folder.root, "the job's files can't be written here", request.output);
    const ArrayJob job = array_job(request, sbatch_options(slurm), arguments);
    refuse_if_busy(folder);
    fs::remove_all(folder.results());
    clear_job(folder);
    write_scripts(job);
    if (slurm.mode == SlurmMode::script) {
        print_submission(folder);
        return kPass;
    }
    return submit_and_wait(job, {.what = scene::plural(request.all.size(), "exploration"),
                                 .go_on = "the same command starts them again"});
}

int merge_explorations(const ExplorationRequest& request, const std::string& job) {
    const JobFolder folder = folder_of(request);
    const std::map<int, int> ended = ended_tasks(folder);
    std::map<int, TaskResults> results;
    ExplorationsFile file(request.json);
    int worst = kPass;
    for (int task = 1; task <= static_cast<int>(request.all.size()); ++task) {
        const Exploration& each = request.all[static_cast<std::size_t>(task) - 1];
        const auto code = ended.find(task);
        const std::string report = code == ended.end() ? "" : whole_report(task_file(folder, task, ".json"));
        print_heading(each);
        if (report.empty()) {
            file.add(each, std::nullopt, "");
            print_line("there is no report; see %s",
                       (folder.logs() / (std::to_string(task) + ".txt")).generic_string().c_str());
            continue;
        }
        results[task] = {true, code->second};
        worst = worse(worst, code->second);
        print_lines(read_bytes(task_file(folder, task, ".txt")));
        file.add(each, code->second, report);
    }
    file.finish();
    const std::vector<std::string> problems =
        task_problems(job, static_cast<int>(request.all.size()), ended, results, ask_task_states(job));
    for (const std::string& problem : problems) {
        print_error_line(problem);
    }
    return problems.empty() ? worst : kRunFailed;
}

const std::vector<std::string>& options_of_exploration() {
    static const std::vector<std::string> names = {"--slurm",  "--partition", "--account", "--time",
                                                   "--mem",    "--sbatch",    "--json",    "--workers",
                                                   "--output", "--only",      "--merge"};
    return names;
}

}  // namespace campuswalk::tools
