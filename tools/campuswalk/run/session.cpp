#include "tools/campuswalk/run/session.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/report/result_json.h"
#include "engine/script/planned_time.h"
#include "tools/campuswalk/base/complaints.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/standard_streams.h"
#include "tools/campuswalk/run/results/verdict.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

using engine::Outcome;
using engine::WalkResult;

Session::Session(Plan plan, SessionSettings settings, Reports& reports, LogOutput* events,
                 LastRunWriter* last_run)
    : plan_(std::move(plan)),
      settings_(std::move(settings)),
      reports_(reports),
      events_(events),
      last_run_(last_run),
      progress_(settings_.progress, plan_.cases.size()),
      renderers_(settings_.play.images ? make_renderers(settings_.backend) : nullptr) {
    for (const Case& each : plan_.cases) {
        over_.push_back(each.walk == nullptr);
    }
}

void Session::take_over(const std::vector<WalkResult>& earlier) {
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

std::vector<std::size_t> Session::to_play() const {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < over_.size(); ++i) {
        if (!over_[i]) {
            indices.push_back(i);
        }
    }
    return indices;
}

int Session::run() {
    watch_for_interrupts();
    reports_.begin(plan_.cases.size());
    check_standard_output();  // workers would inherit what is still to be written
    for (const Case& each : plan_.cases) {
        if (last_run_ != nullptr && each.walk == nullptr) {
            last_run_->add(engine::to_json_line(each.result));
        }
    }
    const std::vector<std::size_t> tasks = to_play();
    workers_ = std::max<std::size_t>(1, std::min(settings_.pool.workers, tasks.size()));
    WorkerPool pool(
        [this](std::size_t index, const Say& say) {
            say(Topic::result, engine::to_json_line(play_case(index, say)));
        },
        settings_.pool);
    PoolListener listener;
    listener.ended_first = [this](std::size_t index, const Ending& ending) { keep(index, ending); };
    listener.heard = [this](std::size_t index, Topic topic, std::string_view lines) {
        if (topic == Topic::place) {
            const Case& played = plan_.cases[index];
            progress_.walk_is_at(played.result.name, std::stod(std::string(lines)),
                                 engine::planned_seconds(played.walk->walk));
        } else {
            hear(topic, lines);
        }
    };
    listener.ended = [this](std::size_t index, const Ending& ending) {
        plan_.cases[index].result = result_of(index, ending);
        over_[index] = true;
        return tell_up_to(index);
    };
    listener.passing_time = [this] {
        progress_.show();
        if (last_run_ != nullptr) {
            last_run_->sync_if_due();
        }
    };
    if (!over_.empty() && over_.front()) {
        tell_up_to(0);
    }
    return finish(!enough() && !pool.run(tasks, listener));
}

WalkResult Session::play_case(std::size_t index, const Say& say) {
    const std::unique_ptr<FrameHelpers> helpers =
        std::exchange(may_fork_, false) ? frame_helpers_for(index) : nullptr;
    return play(plan_.cases[index], settings_.play, {renderers_, helpers.get()}, say);
}

// Where there are processors that no worker has a walk for, each worker gets an equal number of them.
std::unique_ptr<FrameHelpers> Session::frame_helpers_for(std::size_t index) {
    constexpr double kFramesWorthAPart = 10.0;  // what it takes to begin drawing
    const Case& played = plan_.cases[index];
    if (renderers_ == nullptr || !settings_.play.sequence.any()) {
        return nullptr;
    }
    std::size_t parts = std::min(settings_.pool.workers / workers_, FrameHelpers::kMostParts);
    if (const auto seconds = engine::planned_seconds(played.walk->walk)) {
        const double frames = *seconds / interval_of(settings_.play.sequence);
        parts = std::min(parts, static_cast<std::size_t>(std::clamp(frames / kFramesWorthAPart, 1.0, 1e3)));
    }
    if (parts < 2) {
        return nullptr;
    }
    const std::size_t drawing = workers_ * parts;
    std::unique_ptr<FrameHelpers> helpers;
    try {
        helpers = std::make_unique<FrameHelpers>(parts, [&](std::size_t part, const Say& say) {
            share_processors(drawing);
            draw_frames(played, settings_.play, *renderers_, part, parts, say);
        });
        share_processors(drawing);
    } catch (const std::runtime_error&) {
        // No room for more processes: this one draws by itself.
    }
    return helpers;
}

void Session::keep(std::size_t index, const Ending& ending) {
    if (last_run_ != nullptr) {
        last_run_->add(ending.answered ? ending.text : engine::to_json_line(result_of(index, ending)));
    }
}

WalkResult Session::result_of(std::size_t index, const Ending& ending) const {
    if (ending.answered) {
        return engine::result_from_json_line(ending.text);
    }
    WalkResult result = plan_.cases[index].result;
    result.outcome = Outcome::broken;
    result.diagnostics = {"error: " + result.id + ": " + ending.text};
    return result;
}

void Session::hear(Topic topic, std::string_view lines) {
    progress_.hide();
    if (topic == Topic::log) {
        reports_.log(lines);
    } else if (events_ != nullptr) {
        events_->write(lines);
    }
}

bool Session::tell_up_to(std::size_t index) {
    for (; told_ < over_.size() && (told_ <= index || over_[told_]) && !enough(); ++told_) {
        if (over_[told_]) {  // others were being played when the run was interrupted
            tell(std::move(plan_.cases[told_].result));
        }
    }
    return !enough();
}

void Session::tell(WalkResult result) {
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
    if (settings_.told_on_standard_error) {
        for (const std::string& line : verdict_lines(result, settings_.play.output)) {
            diagnostic_line(line);
        }
    }
    const bool failed = !is_good(result) && result.outcome != Outcome::interrupted;
    failures_ += failed ? 1 : 0;
    report_.results.push_back(std::move(result));
}

bool Session::enough() const {
    return settings_.max_failures && failures_ >= *settings_.max_failures;
}

int Session::finish(bool interrupted) {
    if (!interrupted) {
        tell_up_to(over_.size());
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
        diagnostic_line("interrupted");
        return kInterrupted;
    }
    if (const std::size_t left = over_.size() - told_; left > 0) {
        diagnostic_line("stopped after " + std::to_string(failures_) +
                        (failures_ == 1 ? " failure, " : " failures, ") + std::to_string(left) + " not run");
    }
    return exit_code_for(report_.results);
}

}  // namespace campuswalk::tools
