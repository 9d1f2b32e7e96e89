#pragma once

#include "tools/campuswalk/run/plan/plan.h"

namespace campuswalk::tools {

/// A line a case to standard output: its id, its tags as `@tag`, and what sets it apart.
void list_cases(const Plan& plan);

}  // namespace campuswalk::tools
