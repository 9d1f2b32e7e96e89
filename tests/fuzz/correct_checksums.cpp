// Corrects the length and the checksum of damaged files, as a forger would: `correct_checksums FILE…`.

#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/base/checksum.h"

using namespace campuswalk::scene;

int main(int argc, char** argv) {
    for (const char* name : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
        std::ifstream in(name, std::ios::binary);
        std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
        if (bytes.size() < kArchiveHeaderBytes) {
            continue;
        }
        const auto payload = std::as_bytes(std::span(bytes)).subspan(kArchiveHeaderBytes);
        const std::uint64_t size = payload.size();
        const std::uint64_t checksum = checksum_of(payload);
        std::memcpy(bytes.data() + 16, &size, sizeof size);
        std::memcpy(bytes.data() + 24, &checksum, sizeof checksum);
        std::ofstream(name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    return 0;
}
