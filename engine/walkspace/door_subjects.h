#pragma once

#include <vector>

#include "engine/walkspace/subjects.h"

namespace campuswalk::engine {

/// The doors that the campus' models name (find_door_leaves), open ones too. Reached if one gets within half
/// a metre of the leaf on any side; walked through if the body's axis gets into the leaf.
std::vector<Subject> find_doors(const SubjectSearch& search);

}  // namespace campuswalk::engine
