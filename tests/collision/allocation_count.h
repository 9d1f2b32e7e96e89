#pragma once

#include <cstddef>

namespace campuswalk::collision {

/// How often any operator new of this program has been called so far. Linking the definition replaces all of
/// them.
std::size_t allocation_count();

}  // namespace campuswalk::collision
