#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "engine/observers/json_lines.h"
#include "engine/observers/text_log.h"
#include "engine/record/observer.h"
#include "tools/campuswalk/run/cases/case_runner.h"
#include "tools/campuswalk/run/workers/worker.h"

namespace campuswalk::tools {

/// Sends a walk's log to the parent process while the walk is played, some lines at a time: a message for
/// each would cost more than the walk.
class CaseStream final : public engine::Observer {
public:
    /// `say` and `settings` must outlive it. With `keep_lines`, the log as JSON stays here, to be compared.
    CaseStream(const Say& say, const PlaySettings& settings, bool keep_lines);

    void begin(const engine::Walk& walk) override;
    void frame(const engine::TickRecord& record) override;

    /// Sends what is left.
    void flush();
    /// The log as JSON, if it is to be kept.
    const std::vector<std::string>& kept_lines() const { return kept_lines_; }

private:
    using Clock = std::chrono::steady_clock;

    /// Lines that haven't been sent.
    struct Batch {
        Topic topic;
        std::string lines = {};
        Clock::time_point sent = Clock::now();
    };

    void add(Batch& batch, std::string_view line);
    void add_event(std::string_view line);
    void send(Batch& batch);
    /// Whoever watches a slow walk wants to see where it is.
    void send_if_old(Batch& batch, Clock::time_point now);

    const Say& say_;
    const PlaySettings& settings_;
    bool keep_lines_;
    Batch log_{Topic::log};
    Batch events_{Topic::events};
    Clock::time_point place_sent_ = Clock::now();
    engine::TextLog text_;
    engine::JsonLines json_;
    std::vector<std::string> kept_lines_;
};

}  // namespace campuswalk::tools
