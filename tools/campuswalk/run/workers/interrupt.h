#pragma once

#include "engine/record/observer.h"

namespace campuswalk::tools {

/// From now on Ctrl-C (SIGINT) and SIGTERM ask this process to stop instead of ending it.
void watch_for_interrupts();
bool interrupted();
/// Asked more than once: at once, then.
bool interrupted_again();

/// Thrown between two ticks.
struct Interrupted {};

/// Ends a walk between two ticks, so that logs and images stay whole.
class InterruptWatch final : public engine::Observer {
public:
    void frame(const engine::TickRecord&) override {
        if (interrupted()) {
            throw Interrupted{};
        }
    }
};

}  // namespace campuswalk::tools
