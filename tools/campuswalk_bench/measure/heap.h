#pragma once

#include <cstddef>

namespace campuswalk::tools::bench {

/// What this process has allocated and not freed, bytes, with what the allocator adds to each piece. Counts
/// all libraries alike. 0 where another allocator than glibc's is in its place (a sanitizer's).
std::size_t heap_in_use();

}  // namespace campuswalk::tools::bench
