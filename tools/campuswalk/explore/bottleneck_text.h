#pragma once

#include <string>

#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

/// "0.80 m wide between wall (east) and desk".
std::string bottleneck_text(const scene::Campus& campus, const engine::Bottleneck& bottleneck);

/// Whether it is a finding of its own: the only way, and not at a narrow passage that is reported already.
bool is_finding(const engine::WalkReport& report, const engine::Bottleneck& bottleneck);

}  // namespace campuswalk::tools::explore
