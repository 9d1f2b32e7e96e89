#pragma once

#include "engine/observers/line_sink.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// The log that people read and diff: a header line with the settings of the walk, then one line per event.
class TextLog final : public Observer {
public:
    explicit TextLog(LineSink sink) : sink_(std::move(sink)) {}

    void begin(const Walk& walk) override;
    void on_tick(const TickRecord& record) override;

private:
    LineSink sink_;
};

}  // namespace campuswalk::engine
