#pragma once

#include <cstddef>

namespace campuswalk::collision {

/// Asks the system for large pages (2 MiB instead of 4 KiB) for memory that nothing has been written to yet.
/// Queries go here and there in a tree, and in one of many megabytes they wait for addresses to be translated
/// as well as for data. A hint: nothing but speed depends on it.
void prefer_large_pages(void* memory, std::size_t bytes);

}  // namespace campuswalk::collision
