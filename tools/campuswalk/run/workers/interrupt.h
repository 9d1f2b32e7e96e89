#pragma once

#include "engine/record/observer.h"

namespace campuswalk::tools {

/// From now on, SIGINT (Ctrl-C) and SIGTERM request that this process stops instead of ending it.
void watch_for_interrupts();
bool interrupted();
/// Whether it was requested more than once: then it should stop at once.
bool interrupted_again();

/// Thrown between two ticks when the process should stop.
struct Interrupted {};

/// Ends a walk between two ticks, so that logs and images stay whole.
class InterruptWatch final : public engine::Observer {
public:
    void on_tick(const engine::TickRecord&) override {
        if (interrupted()) {
            throw Interrupted{};
        }
    }
};

}  // namespace campuswalk::tools
