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

/// The longest log of the demo campus' walks has 40 kB; events at every tick fill any disk.
inline constexpr std::size_t kMaxLogBytes = std::size_t{1} << 28U;

/// Sends a walk's log to the parent process while the walk is played, several lines at a time: a message per
/// line would cost more than the walk.
class CaseStream final : public engine::Observer {
public:
    /// `send` and `settings` must outlive it. With `save_lines`, it also stores the JSON lines.
    CaseStream(const Send& send, const PlaySettings& settings, bool save_lines);

    void begin(const engine::Walk& walk) override;
    void on_tick(const engine::TickRecord& record) override;

    /// Sends the remaining lines.
    void flush();
    /// The log as JSON lines, if they are stored.
    const std::vector<std::string>& saved_lines() const { return saved_lines_; }

private:
    using Clock = std::chrono::steady_clock;

    /// Lines that haven't been sent yet.
    struct Batch {
        Topic topic;
        std::string lines = {};
        Clock::time_point sent = Clock::now();
    };

    /// Throws std::runtime_error once a log has more than kMaxLogBytes.
    void count(std::string_view line);
    void add(Batch& batch, std::string_view line);
    void add_event(std::string_view line);
    void send(Batch& batch);
    /// So that the log of a slow walk appears while it is played.
    void send_if_old(Batch& batch, Clock::time_point now);

    const Send& send_;
    const PlaySettings& settings_;
    bool save_lines_;
    Batch log_{Topic::log};
    Batch events_{Topic::events};
    Clock::time_point progress_sent_ = Clock::now();
    engine::TextLog text_;
    engine::JsonLines json_;
    std::vector<std::string> saved_lines_;
    std::size_t bytes_ = 0;  ///< of all lines so far, in either form
};

}  // namespace campuswalk::tools
