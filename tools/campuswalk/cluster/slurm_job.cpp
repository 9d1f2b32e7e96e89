#include "tools/campuswalk/cluster/slurm_job.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "scene/base/atomic_file.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/status_line.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/cluster/slurm_program.h"
#include "tools/campuswalk/cluster/slurm_tasks.h"
#include "tools/campuswalk/run/results/progress.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

namespace {

constexpr milliseconds kFirstInterval{500};  // between questions to Slurm
constexpr milliseconds kLastInterval{10'000};
constexpr milliseconds kTick{100};  // between looks at Ctrl-C
constexpr seconds kFileDelay{60};   // until a file of another machine can be seen here, on NFS
constexpr seconds kLineEvery{30};   // where there is no terminal

/// "Submitted batch job 12", "12" or, in a federation, "12;cluster": the last line, as warnings may come
/// first.
std::string job_number(const SlurmAnswer& answer) {
    std::string number;
    for (const std::string_view line : split(answer.text, '\n')) {
        const std::string_view word = line.substr(0, line.find(';'));
        if (!word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos) {
            number = word;
        }
    }
    return number;
}

std::string sbatch(const std::vector<std::string>& arguments, const std::vector<std::string>& variables) {
    const SlurmAnswer answer = ask_slurm("sbatch", arguments, variables);
    std::string number = answer.good() ? job_number(answer) : "";
    if (number.empty()) {
        std::string why = answer.text;
        std::ranges::replace(why, '\n', ' ');
        throw std::runtime_error("the job can't be submitted: sbatch: " + why);
    }
    return number;
}

void make_executable(const fs::path& file) {
    fs::permissions(file, fs::perms::owner_exec, fs::perm_options::add);
}

/// Opening a pipe would wait for a writer.
std::ifstream open_regular(const fs::path& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) ? std::ifstream(file) : std::ifstream();
}

std::optional<int> code_in(const fs::path& file) {
    std::ifstream stream = open_regular(file);
    int code = 0;
    return stream >> code ? std::optional(code) : std::nullopt;
}

std::string words_of(const SlurmJob& job, const QueueState& queue, int tasks) {
    const int done = std::max(0, tasks - queue.waiting - queue.running);
    std::string text =
        std::to_string(done) + " of " + scene::plural(static_cast<std::size_t>(tasks), "task") + " done";
    text += queue.running > 0 ? ", " + std::to_string(queue.running) + " running" : "";
    text += queue.waiting > 0 ? ", " + std::to_string(queue.waiting) + " waiting" : "";
    text += queue.waiting + queue.running == 0 && queue.merging ? ", merging" : "";
    return "job " + job.array + ": " + text;
}

/// What is shown of a job, on a terminal at once, elsewhere seldom.
class JobProgress {
public:
    JobProgress(const SlurmJob& job, int tasks, bool quiet)
        : job_(job),
          tasks_(tasks),
          terminal_(isatty(STDERR_FILENO) == 1),
          quiet_(quiet),
          line_(!quiet && terminal_) {}

    void show(const QueueState& queue) {
        const std::string text = words_of(job_, queue, tasks_);
        if (terminal_) {
            const double open = queue.waiting + queue.running;
            line_.show(progress_bar(1.0 - open / tasks_) + text);
        } else if (!quiet_ && text != last_ && (last_.empty() || Clock::now() - printed_at_ > kLineEvery)) {
            print_error_line(text);
            last_ = text;
            printed_at_ = Clock::now();
        }
    }

    void hide() { line_.hide(); }

private:
    const SlurmJob& job_;
    int tasks_;
    bool terminal_;
    bool quiet_;
    StatusLine line_;
    std::string last_;
    Clock::time_point printed_at_;
};

void sleep_unless_interrupted(milliseconds time) {
    for (const Clock::time_point end = Clock::now() + time; Clock::now() < end;) {
        if (interrupted()) {
            throw Interrupted{};
        }
        std::this_thread::sleep_for(kTick);
    }
}

}  // namespace

void write_scripts(const ArrayJob& job) {
    scene::write_file_atomically(job.folder.shard_script(), shard_script(job));
    scene::write_file_atomically(job.folder.merge_script(), merge_script(job));
    make_executable(job.folder.shard_script());
    make_executable(job.folder.merge_script());
}

SlurmJob submit(const JobFolder& folder, const std::vector<std::string>& variables) {
    SlurmJob job;
    job.array = sbatch({"--parsable", folder.shard_script().string()}, variables);
    try {
        job.merge = sbatch(
            {"--parsable", "--dependency=afterany:" + job.array, folder.merge_script().string(), job.array},
            variables);
    } catch (...) {
        ask_slurm("scancel", {job.array});
        throw;
    }
    scene::write_file_atomically(folder.job(), job.array + " " + job.merge + "\n");
    return job;
}

std::optional<SlurmJob> noted_job(const JobFolder& folder) {
    std::ifstream stream = open_regular(folder.job());
    SlurmJob job;
    const auto is_number = [](const std::string& text) {
        return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    };
    const bool noted = stream >> job.array >> job.merge && is_number(job.array) && is_number(job.merge);
    return noted ? std::optional(job) : std::nullopt;
}

QueueState queue_state(const SlurmJob& job, std::string_view text) {
    QueueState queue;
    for (const std::string_view line : split(text, '\n')) {
        const std::size_t bar = line.find('|');
        if (bar == std::string_view::npos) {
            continue;
        }
        const std::string_view id = line.substr(0, bar);
        const std::string_view state = line.substr(bar + 1);
        if (id == job.merge) {
            queue.merging = true;
        } else if (id.starts_with(job.array + "_")) {
            const auto tasks = static_cast<int>(tasks_in(id.substr(job.array.size() + 1)).size());
            const bool waits = state == "PENDING" || state.starts_with("REQUEUE");
            (waits ? queue.waiting : queue.running) += tasks;
        }
    }
    return queue;
}

QueueState ask_queue(const SlurmJob& job) {
    const SlurmAnswer answer = ask_slurm(
        "squeue", {"--array", "--noheader", "--format=%i|%T", "--jobs=" + job.array + "," + job.merge});
    QueueState queue = queue_state(job, answer.text);
    // Slurm forgets a job some time after its end.
    queue.answered = answer.good() || answer.text.find("Invalid job id") != std::string::npos;
    return queue;
}

void cancel(const SlurmJob& job) {
    ask_slurm("scancel", {job.array, job.merge});
}

std::optional<int> wait_for_merge(const JobFolder& folder, const SlurmJob& job, int tasks, bool quiet) {
    JobProgress progress(job, tasks, quiet);
    milliseconds interval = kFirstInterval;
    Clock::time_point seen = Clock::now();  // when the merge was last in the queue
    while (true) {
        if (const std::optional<int> code = code_in(folder.merged())) {
            progress.hide();
            return code;
        }
        const QueueState queue = ask_queue(job);
        const bool gone = queue.answered && !queue.merging;
        if (!gone) {
            seen = Clock::now();
        } else if (Clock::now() - seen > kFileDelay) {
            return std::nullopt;
        }
        if (queue.answered) {
            progress.show(queue);
        }
        sleep_unless_interrupted(gone ? kFirstInterval : interval);
        interval = std::min(kLastInterval, interval + interval / 8);
    }
}

}  // namespace campuswalk::tools
