#include "scene/import/source/confined_files.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>

#include <assimp/MemoryIOWrapper.h>
#include <assimp/IOStream.hpp>

#include "scene/import/source/obj_text.h"

namespace campuswalk::scene {
namespace {

/// A file on disk, read where it lies: a copy in memory would double the cost of large models.
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

bool ConfinedFiles::Exists(const char* name) const {
    return folder_.find_file(name).has_value();
}

namespace {

bool has_extension(const std::filesystem::path& path, const char* lower_case) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == lower_case;
}

Assimp::IOStream* open_as_it_is(const std::filesystem::path& path) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    std::FILE* file = error ? nullptr : std::fopen(path.c_str(), "rb");
    return file == nullptr ? nullptr : new OpenFile(file, static_cast<std::size_t>(size));
}

}  // namespace

/// Text made such that assimp can read it; nullptr when the file can't be read.
Assimp::IOStream* ConfinedFiles::open_collada(const std::filesystem::path& path) {
    auto text = read_bytes(path);
    if (!text) {
        return nullptr;
    }
    trim_element_starts(*text);
    geographic_ = read_geography(*text);
    auto* copy = new std::uint8_t[text->size()];  // assimp's stream deletes it
    std::ranges::copy(*text, copy);
    return new Assimp::MemoryIOStream(copy, text->size(), true);
}

/// Assimp opens it more than once.
Assimp::IOStream* ConfinedFiles::open_obj(const std::filesystem::path& path) {
    if (!obj_) {
        obj_ = read_bytes(path).value_or(std::vector<std::uint8_t>());
        origin_ = move_vertices_near(*obj_, metres_per_unit_);
        dropped_uvs_ = drop_absent_uvs(*obj_);
        if (origin_.isZero(0.0) && !dropped_uvs_) {
            obj_ = std::vector<std::uint8_t>();
        }
    }
    return obj_->empty() ? open_as_it_is(path) : new Assimp::MemoryIOStream(obj_->data(), obj_->size());
}

Assimp::IOStream* ConfinedFiles::Open(const char* name, const char* mode) {
    const bool for_reading = std::strchr(mode, 'w') == nullptr && std::strchr(mode, 'a') == nullptr;
    const auto path = for_reading ? folder_.find_file(name) : std::nullopt;
    Assimp::IOStream* stream = !path                          ? nullptr
                               : has_extension(*path, ".dae") ? open_collada(*path)
                               : has_extension(*path, ".obj") ? open_obj(*path)
                                                              : open_as_it_is(*path);
    if (stream == nullptr) {
        refused_.emplace_back(name);
    }
    return stream;
}

void ConfinedFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

}  // namespace campuswalk::scene
