#pragma once

#include <cstddef>

namespace campuswalk::collision {

/// Asks the system for large pages (2 MiB instead of 4 KiB) for memory that hasn't been written to yet.
/// Queries jump around in a tree, and in one of many megabytes they wait for address translation as well as
/// for data. A hint: only speed depends on it.
void prefer_large_pages(void* memory, std::size_t bytes);

}  // namespace campuswalk::collision
