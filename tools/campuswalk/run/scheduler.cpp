#include "tools/campuswalk/run/scheduler.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <sys/resource.h>
#include <unistd.h>

#include "engine/report/result_json.h"
#include "engine/script/player.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/standard_streams.h"
#include "tools/campuswalk/run/results/verdict.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

using engine::Outcome;
using engine::WalkResult;

namespace {

std::uint64_t page_size() {
    return static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Bytes of private writable memory; 0 if the system doesn't tell.
std::uint64_t allocated() {
    std::ifstream statistics("/proc/self/statm");
    std::uint64_t pages = 0;
    constexpr int kData = 6;  // fields: size, resident, shared, text, lib, data
    for (int field = 0; field < kData; ++field) {
        statistics >> pages;
    }
    return statistics ? pages * page_size() : 0;
}

/// Limits what this process may allocate from now on, beyond what it shares with its parent, to its part of
/// the machine's memory: a walk that exhausts the memory must not end those of other workers.
/// Counts private writable memory (RLIMIT_DATA), not the address space that drivers reserve.
void limit_worker_memory(std::size_t workers) {
    const std::uint64_t own = allocated();
    if (own == 0) {
        return;
    }
    const std::uint64_t machine = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * page_size();
    const rlim_t most = own + machine / std::max<std::size_t>(workers, 1);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace

Scheduler::Scheduler(Plan plan, SchedulerSettings settings, Reports& reports, LogOutput* events,
                     LastRunWriter* last_run)
    : plan_(std::move(plan)),
      settings_(std::move(settings)),
      reports_(reports),
      events_(events),
      last_run_(last_run),
      progress_(settings_.progress, plan_.cases.size()) {
    for (const Case& each : plan_.cases) {
        over_.push_back(each.walk == nullptr);
    }
}

void Scheduler::take_over(const std::vector<WalkResult>& earlier) {
    std::map<std::string, const WalkResult*> known;
    for (const WalkResult& result : earlier) {
        if (result.outcome == Outcome::passed || result.outcome == Outcome::failed) {
            known[result.id] = &result;
        }
    }
    for (std::size_t i = 0; i < plan_.cases.size(); ++i) {
        const auto found = known.find(plan_.cases[i].result.id);
        if (!over_[i] && found != known.end()) {
            plan_.cases[i].result = *found->second;
            over_[i] = true;
        }
    }
}

std::vector<std::size_t> Scheduler::to_play() const {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < over_.size(); ++i) {
        if (!over_[i]) {
            indices.push_back(i);
        }
    }
    return indices;
}

int Scheduler::run() {
    watch_for_interrupts();
    reports_.begin(plan_.summary);
    check_standard_output();  // workers would inherit unwritten output
    for (const Case& each : plan_.cases) {
        if (last_run_ != nullptr && each.walk == nullptr) {
            last_run_->add(engine::to_json_line(each.result));
        }
    }
    const std::vector<std::size_t> tasks = to_play();
    const std::size_t workers = std::max<std::size_t>(1, std::min(settings_.pool.workers, tasks.size()));
    settings_.play.drawing = workers;
    settings_.play.processes_each = settings_.pool.workers / workers;
    const StartWork start = [this, workers] {
        limit_worker_memory(workers);
        const auto runner = std::make_shared<CaseRunner>(settings_.play);
        return [this, runner](std::size_t index, const Send& send) {
            send(Topic::result, engine::to_json_line(runner->run(plan_.cases[index], send)));
        };
    };
    if (!over_.empty() && over_.front()) {
        report_up_to(0);
    }
    return finish(!has_enough_failures() && !WorkerPool(start, tasks, listener(), settings_.pool).run());
}

PoolListener Scheduler::listener() {
    PoolListener listener;
    listener.on_result = [this](std::size_t index, const Ending& ending) { save(index, ending); };
    listener.on_message = [this](std::size_t index, Topic topic, std::string_view body) {
        handle_message(index, topic, body);
    };
    listener.on_end = [this](std::size_t index, const Ending& ending) {
        plan_.cases[index].result = result_of(index, ending);
        over_[index] = true;
        return report_up_to(index);
    };
    listener.update_progress = [this] {
        progress_.show();
        if (last_run_ != nullptr) {
            last_run_->sync_if_due();
        }
    };
    return listener;
}

void Scheduler::save(std::size_t index, const Ending& ending) {
    if (last_run_ != nullptr) {
        last_run_->add(ending.answered ? ending.text : engine::to_json_line(result_of(index, ending)),
                       ending.microseconds);
    }
}

WalkResult Scheduler::result_of(std::size_t index, const Ending& ending) const {
    if (ending.answered) {
        return engine::result_from_json_line(ending.text);
    }
    WalkResult result = plan_.cases[index].result;
    result.outcome = Outcome::broken;
    result.diagnostics = {{scene::Severity::error, {}, {}, result.id + ": " + ending.text}};
    return result;
}

void Scheduler::handle_message(std::size_t index, Topic topic, std::string_view body) {
    if (topic == Topic::progress) {
        const Case& played = plan_.cases[index];
        progress_.walk_is_at(played.result.name, std::stod(std::string(body)),
                             engine::planned_seconds(played.walk->walk));
        return;
    }
    progress_.hide();
    if (topic == Topic::log) {
        reports_.log(body);
    } else if (events_ != nullptr) {
        events_->write(body);
    }
}

bool Scheduler::report_up_to(std::size_t index) {
    for (; reported_ < over_.size() && (reported_ <= index || over_[reported_]) && !has_enough_failures();
         ++reported_) {
        if (over_[reported_]) {  // the others were being played when the run was interrupted
            report(std::move(plan_.cases[reported_].result));
        }
    }
    return !has_enough_failures();
}

void Scheduler::report(WalkResult result) {
    if (result.repetition == 0) {
        first_ = result;
    } else if (settings_.require_identical) {
        compare_repetitions(first_, result);
    }
    progress_.count(is_good(result));
    reports_.result(result);
    if (events_ != nullptr) {
        events_->flush();
    }
    if (settings_.print_verdicts) {
        for (const std::string& line : verdict_lines(result, settings_.play.output)) {
            print_error_line(line);
        }
    }
    const bool failed = !is_good(result) && result.outcome != Outcome::interrupted;
    failures_ += failed ? 1 : 0;
    report_.results.push_back(std::move(result));
}

bool Scheduler::has_enough_failures() const {
    return settings_.max_failures && failures_ >= *settings_.max_failures;
}

int Scheduler::finish(bool interrupted) {
    if (!interrupted) {
        report_up_to(over_.size());
    }
    progress_.hide();
    reports_.end(report_);
    if (events_ != nullptr) {
        events_->flush();
    }
    if (last_run_ != nullptr) {
        last_run_->close();
    }
    if (interrupted) {
        print_error_line("interrupted");
        return kInterrupted;
    }
    if (const std::size_t left = over_.size() - reported_; left > 0) {
        print_error_line("stopped after " + scene::plural(static_cast<std::size_t>(failures_), "failure") +
                         ", " + std::to_string(left) + " not run");
    }
    return exit_code_for(report_.results);
}

}  // namespace campuswalk::tools
