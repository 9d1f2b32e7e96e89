#include "tools/campuswalk/explore/bottleneck_text.h"

#include <algorithm>
#include <array>

#include "engine/events/decimals.h"
#include "engine/walkspace/barrier/barrier_reason.h"

namespace campuswalk::tools::explore {

std::string bottleneck_text(const scene::Campus& campus, const engine::Bottleneck& bottleneck) {
    const engine::PassageWidth& passage = bottleneck.passage;
    std::array<std::string, 2> sides;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        sides[i] = engine::object_text(campus, passage.sides[i].object, passage.sides[i].at);
    }
    std::ranges::sort(sides);
    const std::string both =
        sides[0] == sides[1] ? "within " + sides[0] : "between " + sides[0] + " and " + sides[1];
    return engine::fixed(passage.width, 2) + " m wide " + both;
}

bool is_finding(const engine::WalkReport& report, const engine::Bottleneck& bottleneck) {
    constexpr double kSamePassage = 1.0;  // metres
    const auto is_reported = [&](const engine::NarrowPassage& entry) {
        const collision::Vec3& foot = bottleneck.passage.foot;
        return entry.passage && ((entry.passage->at - foot).norm() <= kSamePassage ||
                                 (entry.passage->from - foot).norm() <= kSamePassage);
    };
    return bottleneck.is_only_path && std::ranges::none_of(report.narrow, is_reported);
}

}  // namespace campuswalk::tools::explore
