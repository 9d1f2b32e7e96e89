#include "tests/walks/audited_run.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "config/loader/load_run.h"
#include "engine/events/decimals.h"
#include "engine/observers/text_log.h"
#include "engine/script/avatar_body.h"
#include "engine/simulation/check_walk.h"

namespace campuswalk::support {

namespace {

/// Metres; allows for rounding.
constexpr double kAllowed = 1e-6;

}  // namespace

void TickAudit::on_tick(const engine::TickRecord& record) {
    if (record.tick < ticks_) {
        return;  // the closing events, at the last tick again
    }
    ticks_ = static_cast<int>(record.tick) + 1;
    if (std::ranges::any_of(record.events, [](const engine::Event& event) {
            return event.kind == engine::EventKind::avatar_teleport;
        })) {
        last_.reset();  // a teleport passes through nothing
    }
    check(record.avatar, record.time);
    last_ = record.avatar.position;
}

void TickAudit::check(const engine::AvatarState& avatar, double time) {
    const Point& foot = avatar.position;
    const double height = avatar.stature * avatar_.height;
    const Penetration worst = oracle_.worst_penetration(foot, avatar_.radius, height);
    if (worst.depth > kAllowed) {
        diagnostics_.push_back("at " + engine::fixed(time, 3) + " s " +
                               engine::fixed(1000.0 * worst.depth, 3) + " mm inside object " +
                               std::to_string(worst.object.value_or(0)));
    }
    if (!last_) {
        return;
    }
    if (const auto object = oracle_.crossed(*last_, foot, avatar_.radius, height)) {
        diagnostics_.push_back("at " + engine::fixed(time, 3) + " s through object " +
                               std::to_string(*object));
    }
}

AuditedRun audited_run(const std::filesystem::path& walk_file) {
    config::Run loaded = config::load_run(
        walk_file, {.avatars = {},
                    .lights = {},
                    .roots = {std::filesystem::path(CAMPUSWALK_SOURCE_DIR) / ".." / "shared" / "data"}});
    std::vector<scene::Diagnostic> warnings;
    AuditedRun run{
        .walk = std::move(loaded.walk),
        .campus = scene::load_campus(*loaded.campus, collision::make_bullet_broad_phase(), warnings)};
    std::vector<scene::Diagnostic> mistakes = engine::check_walk(run.campus, run.walk);
    std::erase_if(mistakes,
                  [](const scene::Diagnostic& each) { return each.severity != scene::Severity::error; });
    if (!mistakes.empty()) {
        throw scene::InputError(std::move(mistakes));
    }
    const PenetrationOracle oracle(
        run.campus.world, {collision::Detection::solid, engine::ignored_layers(run.campus, run.walk.avatar)});
    TickAudit audit(oracle, run.walk.avatar);
    engine::TextLog log([&](std::string_view line) { run.log.emplace_back(line); });
    std::vector<engine::Observer*> observers = {&log, &audit};
    run.summary = engine::run_walk(run.campus, run.walk, observers);
    run.ticks = audit.ticks();
    run.end = audit.last_foot();
    run.diagnostics = audit.diagnostics();
    return run;
}

void expect_passed(const AuditedRun& run) {
    for (const engine::Failure& failure : run.summary.failures) {
        ADD_FAILURE() << failure.mark.line << ": " << failure.message;
    }
}

void expect_clean(const AuditedRun& run) {
    for (const std::string& diagnostic : run.diagnostics) {
        ADD_FAILURE() << diagnostic;
    }
}

}  // namespace campuswalk::support
