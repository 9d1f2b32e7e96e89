#pragma once

#include "engine/observers/line_sink.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// The same as the text log, for programs: a header object, then one object per line and event, with the text
/// log's names and decimals; positions are arrays.
class JsonLines final : public Observer {
public:
    explicit JsonLines(LineSink sink) : sink_(std::move(sink)) {}

    void begin(const Walk& walk) override;
    void on_tick(const TickRecord& record) override;

private:
    LineSink sink_;
};

}  // namespace campuswalk::engine
