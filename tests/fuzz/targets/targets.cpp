#include "tests/fuzz/targets/targets.h"

#include <array>
#include <string_view>

namespace campuswalk::fuzz {

std::vector<std::byte> forged(const scene::FileKind& kind, Bytes payload) {
    scene::ArchiveWriter writer(kind);
    writer.put_all(payload);
    return scene::concatenated(writer.finish());
}

const Target* find_target(const char* name) {
    for (const std::span<const Target> targets :
         {model_targets(), map_targets(), archive_targets(), text_targets()}) {
        for (const Target& target : targets) {
            if (std::string_view(target.name) == name) {
                return &target;
            }
        }
    }
    return nullptr;
}

}  // namespace campuswalk::fuzz
