#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/record/observer.h"
#include "engine/simulation/run_walk.h"
#include "tests/support/penetration_oracle.h"

namespace campuswalk::support {

/// Checks with the oracle, after every tick, whether the avatar is inside anything or its axis passed through
/// it.
class TickAudit final : public engine::Observer {
public:
    TickAudit(const PenetrationOracle& oracle, const engine::AvatarProfile& avatar)
        : oracle_(oracle), avatar_(avatar) {}

    void on_tick(const engine::TickRecord& record) override;

    int ticks() const { return ticks_; }
    /// Where the walk ended.
    Point last_foot() const { return last_.value_or(Point::Zero()); }
    const std::vector<std::string>& diagnostics() const { return diagnostics_; }

private:
    void check(const engine::AvatarState& avatar, double time);

    const PenetrationOracle& oracle_;
    engine::AvatarProfile avatar_;
    std::optional<Point> last_;
    int ticks_ = 0;
    std::vector<std::string> diagnostics_;
};

/// A walk that was loaded from its file and run, with its log and every tick audited.
struct AuditedRun {
    engine::Walk walk;
    scene::Campus campus;
    engine::WalkSummary summary = {};
    std::vector<std::string> log = {};  ///< lines without their ends
    int ticks = 0;
    Point end = Point::Zero();
    std::vector<std::string> diagnostics = {};  ///< of the oracle
};

/// Loads, checks and runs as `campuswalk run` does, without images. Throws scene::InputError.
AuditedRun audited_run(const std::filesystem::path& walk_file);

/// Fails the test for each expectation of the walk that doesn't hold, and for a step that ended it.
void expect_passed(const AuditedRun& run);
/// Fails the test for each of the oracle's diagnostics.
void expect_clean(const AuditedRun& run);

}  // namespace campuswalk::support
