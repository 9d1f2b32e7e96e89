#include "scene/cache/program_hash.h"

#include "scene/cache/mapped_file.h"

namespace campuswalk::scene {

const ContentHash& program_hash() {
    static const ContentHash hash = [] {
        const auto program = MappedFile::open("/proc/self/exe");
        return program ? hash_of(program->bytes()) : ContentHash{};
    }();
    return hash;
}

}  // namespace campuswalk::scene
