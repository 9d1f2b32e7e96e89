#include "scene/cache/program_hash.h"

#include "scene/cache/file_contents.h"

namespace campuswalk::scene {

const ContentHash& program_hash() {
    static const ContentHash hash = hash_of_file("/proc/self/exe").value_or(ContentHash{});
    return hash;
}

}  // namespace campuswalk::scene
