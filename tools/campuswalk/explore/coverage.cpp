#include "tools/campuswalk/explore/coverage.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "engine/report/outcome.h"
#include "engine/simulation/run_walk.h"
#include "engine/walkspace/space/node_numbers.h"

namespace campuswalk::tools::explore {

namespace {

using engine::SubjectKind;

/// A visitor's foot and a node this near in height are on one ground, metres.
constexpr double kSameGround = 0.35;

/// Marks the nodes under the visitors' bodies, and what they come into contact with.
class Visits final : public engine::Observer {
public:
    Visits(const scene::Campus& campus, const engine::WalkSpace& space)
        : campus_(campus), space_(space), numbers_(space), visited_(numbers_.count(), false) {
        for (std::size_t i = 0; i < campus.objects.size(); ++i) {
            objects_[campus.objects[i].id] = i;
        }
    }

    void begin(const engine::Walk& walk) override { radius_ = walk.avatar.radius; }

    void on_tick(const engine::TickRecord& record) override {
        if (record.avatar.grounded) {
            mark_ground(record.avatar.position);
        }
        for (const engine::Event& event : record.events) {
            const auto object = objects_.find(event.object);
            if (object == objects_.end() || !is_contact(event.kind)) {
                continue;
            }
            if (event.kind == engine::EventKind::trigger_enter) {
                triggers_.insert(event.object);
            }
            if (const auto building = campus_.objects[object->second].building) {
                buildings_.insert(campus_.description.buildings[*building].id);
            }
        }
    }

    double area() const {
        std::size_t count = 0;
        numbers_.for_each([&](const engine::WalkNodeId& id) {
            count += visited_[numbers_(id)] && space_.node(id).hangs == 0 ? 1U : 0U;
        });
        return static_cast<double>(count) * space_.grid.cell * space_.grid.cell;
    }
    bool has(const engine::Subject& subject) const {
        return subject.kind == SubjectKind::building  ? buildings_.contains(subject.name)
               : subject.kind == SubjectKind::trigger ? triggers_.contains(subject.name)
                                                      : false;
    }

private:
    static bool is_contact(engine::EventKind kind) {
        return kind == engine::EventKind::trigger_enter || kind == engine::EventKind::collision_enter ||
               kind == engine::EventKind::ray_enter;
    }

    void mark_ground(const collision::Vec3& foot) {
        const double cell = space_.grid.cell;
        const engine::GridCell low = space_.grid.cell_at(foot.x() - radius_, foot.z() - radius_);
        const engine::GridCell high = space_.grid.cell_at(foot.x() + radius_, foot.z() + radius_);
        for (int z = low.z; z <= high.z; ++z) {
            for (int x = low.x; x <= high.x; ++x) {
                const collision::Vec3 apart = space_.grid.center({x, z}) - foot;
                if (collision::horizontal_norm(apart) > std::max(radius_, cell)) {
                    continue;
                }
                if (const auto node = space_.find({x, z}, foot.y(), kSameGround)) {
                    visited_[numbers_(*node)] = true;
                }
            }
        }
    }

    const scene::Campus& campus_;
    const engine::WalkSpace& space_;
    engine::NodeNumbers numbers_;
    std::vector<bool> visited_;
    std::map<std::string, std::size_t> objects_;
    std::set<std::string> triggers_;
    std::set<std::string> buildings_;
    double radius_ = 0.0;
};

}  // namespace

Coverage measure_coverage(const scene::Campus& campus, const engine::WalkReport& report,
                          const std::vector<engine::Walk>& walks) {
    Visits visits(campus, report.space);
    Coverage coverage;
    coverage.walks = walks.size();
    for (const engine::Walk& walk : walks) {
        const std::array<engine::Observer*, 1> observers{&visits};
        const engine::EvaluatedWalk verdict =
            engine::outcome_of_failures(engine::run_walk(campus, walk, observers).failures, walk.status);
        coverage.failed += verdict.outcome == engine::Outcome::passed ? 0U : 1U;
    }
    coverage.area = visits.area();
    const double reached = report.space.area();
    coverage.share = reached > 0.0 ? coverage.area / reached : 0.0;
    for (const engine::SubjectReport& entry : report.subjects) {
        coverage.visited.push_back(visits.has(entry.subject));
    }
    return coverage;
}

}  // namespace campuswalk::tools::explore
