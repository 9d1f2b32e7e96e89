#include "tools/campuswalk/suggest/frame_hints.h"

#include <algorithm>

#include "tools/campuswalk/suggest/frame_text.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

namespace {

double footprint(const scene::Bounds& bounds) {
    const Eigen::Vector3d size = bounds.max - bounds.min;
    return bounds.empty() ? 0.0 : size.x() * size.z();
}

}  // namespace

std::vector<scene::Diagnostic> frame_hints(const scene::Campus& campus) {
    constexpr double kMost = 0.5;  // of the largest footprint: a bench may be a sculpture
    double largest = 0.0;
    for (const scene::Model& model : campus.models) {
        largest = std::max(largest, footprint(world_bounds(model)));
    }
    std::vector<scene::Diagnostic> hints;
    for (std::size_t i = 0; i < campus.models.size(); ++i) {
        if (footprint(world_bounds(campus.models[i])) < kMost * largest) {
            continue;
        }
        UprightModel upright;
        upright.file = campus.description.scenes[i];
        upright.model = campus.models[i];
        upright.frame = scene::guess_frame(upright.model);
        for (const scene::ModelLint& lint : frame_lints(upright)) {
            hints.push_back({scene::Severity::warning, upright.file.mark, lint.code,
                             "'" + upright.file.file + "': " + lint.message});
        }
    }
    return hints;
}

}  // namespace campuswalk::tools
