#include "tools/campuswalk/run/plan/plan_options.h"

namespace campuswalk::tools {

PlanOptions plan_options(const RunOptions& options) {
    PlanOptions plan;
    if (options.grep) {
        plan.selector.require(*options.grep, {"--grep", 0, 0});
    }
    if (options.grep_invert) {
        plan.selector.refuse(*options.grep_invert, {"--grep-invert", 0, 0});
    }
    plan.selector.require_tag(options.tags);
    plan.repeat_each = options.repeat_each;
    plan.tree = options.tree;
    plan.max_timeout = options.timeout;
    return plan;
}

}  // namespace campuswalk::tools
