#include "scene/import/locked_files.h"

#include <algorithm>
#include <cstring>
#include <fstream>

#include <assimp/IOStream.hpp>

namespace campuswalk::scene {
namespace {

class BytesInMemory final : public Assimp::IOStream {
public:
    explicit BytesInMemory(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}

    std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
        if (size == 0 || count == 0) {
            return 0;
        }
        const std::size_t items = std::min(count, (bytes_.size() - at_) / size);
        if (items > 0) {
            std::memcpy(buffer, bytes_.data() + at_, items * size);
        }
        at_ += items * size;
        return items;
    }
    std::size_t Write(const void* /*buffer*/, std::size_t /*size*/, std::size_t /*count*/) override {
        return 0;
    }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
        const std::size_t target = base + offset;  // wraps for a negative offset, as assimp expects
        if (target > bytes_.size()) {
            return aiReturn_FAILURE;
        }
        at_ = target;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    std::vector<std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<std::vector<std::uint8_t>> read_bytes(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    if (!in) {
        return std::nullopt;
    }
    const std::streamoff size = in.tellg();
    if (size < 0) {
        return std::nullopt;
    }
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    in.seekg(0);
    in.read(reinterpret_cast<char*>(bytes.data()), size);
    if (!in) {
        return std::nullopt;
    }
    return bytes;
}

bool LockedFiles::Exists(const char* name) const {
    return folder_.find_file(name).has_value();
}

Assimp::IOStream* LockedFiles::Open(const char* name, const char* mode) {
    const bool for_reading = std::strchr(mode, 'w') == nullptr && std::strchr(mode, 'a') == nullptr;
    const auto path = for_reading ? folder_.find_file(name) : std::nullopt;
    auto bytes = path ? read_bytes(*path) : std::nullopt;
    if (!bytes) {
        refused_.emplace_back(name);
        return nullptr;
    }
    return new BytesInMemory(std::move(*bytes));
}

void LockedFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

}  // namespace campuswalk::scene
