#include "scene/import/source/confined_files.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>

#include <assimp/MemoryIOWrapper.h>
#include <assimp/IOStream.hpp>

#include "scene/import/source/mtl_text.h"
#include "scene/import/source/obj_text.h"
#include "scene/import/source/off_text.h"
#include "scene/import/source/ply_header.h"
#include "scene/import/source/stl_text.h"

namespace campuswalk::scene {
namespace {

/// A file on disk, not copied to memory: that would double the memory for large models.
class OpenFile final : public Assimp::IOStream {
public:
    OpenFile(std::FILE* file, std::size_t size) : file_(file, &std::fclose), size_(size) {}

    std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
        return size == 0 || count == 0 ? 0 : std::fread(buffer, size, count, file_.get());
    }
    std::size_t Write(const void* /*buffer*/, std::size_t /*size*/, std::size_t /*count*/) override {
        return 0;
    }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? Tell() : size_;
        const std::size_t target = base + offset;  // wraps for a negative offset, as assimp expects
        const bool moved =
            target <= size_ && std::fseek(file_.get(), static_cast<long>(target), SEEK_SET) == 0;
        return moved ? aiReturn_SUCCESS : aiReturn_FAILURE;
    }
    std::size_t Tell() const override {
        const long at = std::ftell(file_.get());
        return at < 0 ? 0 : static_cast<std::size_t>(at);
    }
    std::size_t FileSize() const override { return size_; }
    void Flush() override {}

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::size_t size_ = 0;
};

Assimp::IOStream* open_unchanged(const std::filesystem::path& path) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    std::FILE* file = error ? nullptr : std::fopen(path.c_str(), "rb");
    return file == nullptr ? nullptr : new OpenFile(file, static_cast<std::size_t>(size));
}

Assimp::IOStream* copy_of(const std::vector<std::uint8_t>& text) {
    auto* copy = new std::uint8_t[text.size()];  // owned by the stream
    std::ranges::copy(text, copy);
    return new Assimp::MemoryIOStream(copy, text.size(), true);
}

Assimp::IOStream* open_ply(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::vector<std::uint8_t> text = rewrite_ply(in);
    return text.empty() ? open_unchanged(path) : copy_of(text);
}

Assimp::IOStream* open_stl(const std::filesystem::path& path) {
    auto stl = read_bytes(path);
    if (!stl) {
        return nullptr;
    }
    normalize_stl(*stl);
    return copy_of(*stl);
}

}  // namespace

bool ConfinedFiles::Exists(const char* name) const {
    return folder_.find_file(name).has_value();
}

Assimp::IOStream* ConfinedFiles::open_collada(const std::filesystem::path& path) {
    auto text = read_bytes(path);
    if (!text) {
        return nullptr;
    }
    trim_element_starts(*text);
    collada_ = read_collada_facts(*text);
    fault_ = collada_.fault;
    if (!fault_.empty()) {
        return nullptr;
    }
    return copy_of(*text);
}

/// Assimp opens it more than once: the result is cached.
Assimp::IOStream* ConfinedFiles::open_obj(const std::filesystem::path& path) {
    if (!obj_) {
        obj_ = read_bytes(path).value_or(std::vector<std::uint8_t>());
        fault_ = normalize_obj(*obj_);
        origin_ = move_vertices_near(*obj_, metres_per_unit_);
        dropped_uvs_ = drop_absent_uvs(*obj_);
    }
    return fault_.empty() ? new Assimp::MemoryIOStream(obj_->data(), obj_->size()) : nullptr;
}

Assimp::IOStream* ConfinedFiles::open_mtl(const std::filesystem::path& path) {
    if (const auto text = read_bytes(path)) {
        moves_images_ = moves_images_ || scene::moves_images(*text);
    }
    return open_unchanged(path);
}

Assimp::IOStream* ConfinedFiles::open_off(const std::filesystem::path& path) {
    fault_ = fault_of_off(read_bytes(path).value_or(std::vector<std::uint8_t>()));
    return fault_.empty() ? open_unchanged(path) : nullptr;
}

Assimp::IOStream* ConfinedFiles::Open(const char* name, const char* mode) {
    const bool for_reading = std::strchr(mode, 'w') == nullptr && std::strchr(mode, 'a') == nullptr;
    const auto path = for_reading ? folder_.find_file(name) : std::nullopt;
    const std::string extension = path ? lower_case(path->extension().string()) : "";
    Assimp::IOStream* stream = !path                 ? nullptr
                               : extension == ".dae" ? open_collada(*path)
                               : extension == ".obj" ? open_obj(*path)
                               : extension == ".mtl" ? open_mtl(*path)
                               : extension == ".off" ? open_off(*path)
                               : extension == ".ply" ? open_ply(*path)
                               : extension == ".stl" ? open_stl(*path)
                                                     : open_unchanged(*path);
    if (stream == nullptr) {
        refused_.emplace_back(name);
    }
    return stream;
}

void ConfinedFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

}  // namespace campuswalk::scene
