#pragma once

#include <string>

#include "engine/observers/line_sink.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// The log that people read and diff: a line an event, after a header line with what the walk ran with.
class TextLog final : public Observer {
public:
    explicit TextLog(LineSink sink) : sink_(std::move(sink)) {}

    void begin(const Walk& walk) override;
    void frame(const TickRecord& record) override;

private:
    LineSink sink_;
};

}  // namespace campuswalk::engine
