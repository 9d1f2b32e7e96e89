#pragma once

#include <cstddef>

namespace campuswalk::tools::bench {

/// The bytes that this process, with all libraries, has allocated and not freed, including the allocator's
/// overhead. 0 if glibc's allocator is replaced (by a sanitizer's).
std::size_t heap_in_use();

}  // namespace campuswalk::tools::bench
