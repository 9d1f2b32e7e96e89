#pragma once

#include <cstddef>

namespace campuswalk::collision {

/// How often this program's operators new have been called so far, whichever of them and by whom. Their
/// replacements come with this file's definition: a program has them all or none.
std::size_t allocation_count();

}  // namespace campuswalk::collision
