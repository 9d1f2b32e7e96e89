#include "tools/campuswalk_bench/measure/heap.h"

#include <malloc.h>

namespace campuswalk::tools::bench {

std::size_t heap_in_use() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

}  // namespace campuswalk::tools::bench
