#pragma once

#include <string>

#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

/// The spawn that is one of the space's starts.
std::string name_of_start(const scene::Campus& campus, const engine::WalkReport& report,
                          const engine::WalkNodeId& start);
/// The spawn from which the subject's distance is measured: that which the chain of strides to it begins at.
/// Empty if it has no distance.
std::string start_of(const scene::Campus& campus, const engine::WalkReport& report,
                     const engine::SubjectReport& entry);

}  // namespace campuswalk::tools::explore
