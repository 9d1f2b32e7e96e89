#pragma once

#include <vector>

#include "engine/walkspace/report/subjects.h"

namespace campuswalk::engine {

/// The doors that the campus' models name (find_door_leaves), open ones too. Reached if one gets within half
/// a metre of the leaf on any side, and no lower than a riser below it; walked through if the body gets so
/// far into the leaf that it can't be solid.
std::vector<Subject> find_doors(const SubjectSearch& search);

}  // namespace campuswalk::engine
