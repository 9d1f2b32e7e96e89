#include "collision/base/large_pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace campuswalk::collision {

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
    // The size on x86. Memory without a whole large page is left alone: each call may split a mapping in
    // three.
    constexpr std::uintptr_t kPage = 2U << 20U;
    const auto start = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (start + kPage - 1) / kPage * kPage;
    const std::uintptr_t end = (start + bytes) / kPage * kPage;
    if (first < end) {
        // Fails, harmlessly, if the kernel has no large pages.
        madvise(static_cast<std::byte*>(memory) + (first - start), end - first, MADV_HUGEPAGE);
    }
#endif
}

}  // namespace campuswalk::collision
