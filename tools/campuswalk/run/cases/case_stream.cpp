#include "tools/campuswalk/run/cases/case_stream.h"

#include <stdexcept>

#include "engine/events/decimals.h"

namespace campuswalk::tools {

CaseStream::CaseStream(const Send& send, const PlaySettings& settings, bool save_lines)
    : send_(send),
      settings_(settings),
      save_lines_(save_lines),
      text_([this](std::string_view line) { add(log_, line); }),
      json_([this](std::string_view line) { add_event(line); }) {}

void CaseStream::begin(const engine::Walk& walk) {
    if (settings_.log) {
        text_.begin(walk);
    }
    if (settings_.events || save_lines_) {
        json_.begin(walk);
    }
}

void CaseStream::on_tick(const engine::TickRecord& record) {
    if (settings_.log) {
        text_.on_tick(record);
    }
    if (settings_.events || save_lines_) {
        json_.on_tick(record);
    }
    const Clock::time_point now = Clock::now();
    if (settings_.progress && now - progress_sent_ > std::chrono::milliseconds(200)) {
        progress_sent_ = now;
        send_(Topic::progress, engine::fixed(record.time, 1));
    }
    send_if_old(log_, now);
    send_if_old(events_, now);
}

void CaseStream::flush() {
    send(log_);
    send(events_);
}

void CaseStream::add(Batch& batch, std::string_view line) {
    constexpr std::size_t kEnough = std::size_t{1} << 14U;
    count(line);
    batch.lines.append(line);
    batch.lines += '\n';
    if (batch.lines.size() >= kEnough) {
        send(batch);
    }
}

void CaseStream::add_event(std::string_view line) {
    if (settings_.events) {
        add(events_, line);
    }
    if (save_lines_) {
        count(line);
        saved_lines_.emplace_back(line);
    }
}

void CaseStream::count(std::string_view line) {
    bytes_ += line.size() + 1;
    if (bytes_ > kMaxLogBytes) {
        throw std::runtime_error("its log has more than " + std::to_string(kMaxLogBytes >> 20U) +
                                 " MB; log stays less often ('stay_every'), or split the walk");
    }
}

void CaseStream::send(Batch& batch) {
    if (!batch.lines.empty()) {
        send_(batch.topic, batch.lines);
        batch.lines.clear();
    }
}

void CaseStream::send_if_old(Batch& batch, Clock::time_point now) {
    if (!batch.lines.empty() && now - batch.sent > std::chrono::milliseconds(100)) {
        send(batch);
        batch.sent = now;
    }
}

}  // namespace campuswalk::tools
