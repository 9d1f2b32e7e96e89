#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "engine/report/reporter.h"

namespace campuswalk::tools {

/// Lets another reporter work in a thread of its own, so that whoever hands out walks doesn't wait for it. It
/// gets the same calls in the same order; what it throws is thrown at the next call. Processes are forked
/// only while the thread does nothing, so that they find no lock taken.
class BackgroundReporter final : public engine::Reporter {
public:
    explicit BackgroundReporter(std::unique_ptr<engine::Reporter> reporter);
    ~BackgroundReporter() override;

    void begin(const engine::RunPlan& plan) override;
    /// Waits while the other one is far behind: what waits for it is held in memory.
    void result(const engine::WalkResult& result) override;
    void end(const engine::ResultSequence& results) override;

private:
    void start();
    void work();
    void stop();
    void throw_if_failed();

    std::unique_ptr<engine::Reporter> reporter_;
    std::thread thread_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<engine::WalkResult> waiting_;
    bool closed_ = false;
    std::exception_ptr failure_;
};

}  // namespace campuswalk::tools
