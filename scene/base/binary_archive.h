#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "collision/base/large_pages.h"
#include "collision/base/storage.h"

namespace campuswalk::scene {

/// The frame of our binary files. 64 bytes first: eight that name the kind, a number that shows the byte
/// order, the kind's version, the payload's size and its checksum, zeros; then the payload. Numbers are as
/// this machine has them: a file is for the machine that wrote it and those like it.

struct FileKind {
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
};

/// A file that isn't what it must be: damaged, foreign, of another version, or forged. `what()` says how, in
/// words for the user ("it is truncated").
class DamagedFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t kArchiveHeaderBytes = 64;

/// What is copied as it lies in memory.
template <typename T>
concept Plain = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

/// Bytes that lie in several places, in the order of the file.
using Parts = std::vector<std::span<const std::byte>>;

class ArchiveWriter {
public:
    explicit ArchiveWriter(const FileKind& kind);

    template <Plain T>
    void put(T value) {
        put_bytes(&value, sizeof value);
    }
    void put_text(std::string_view text);
    /// The elements alone; their number is put before, wherever the reader can't know it. Many are left where
    /// they are, and must stay there until the file is written.
    template <typename Element>
    void put_all(std::span<const Element> elements) {
        put_elements(std::as_bytes(elements));
    }
    /// Likewise, from the next multiple of their alignment on.
    template <typename Element>
    void put_aligned(std::span<const Element> elements) {
        align(alignof(Element));
        put_all(elements);
    }
    /// Zeros up to the next multiple of `alignment`, counted from the file's start.
    void align(std::size_t alignment);

    /// The whole file, to be written part by part. Nothing is to be put from now on; the writer stays.
    Parts finish();

private:
    /// Elements that are elsewhere, after so many bytes of those here.
    struct Left {
        std::size_t after = 0;
        std::span<const std::byte> elements;
    };

    void put_bytes(const void* from, std::size_t count);
    void put_elements(std::span<const std::byte> elements);

    std::vector<std::byte> bytes_;  ///< but for those elsewhere
    std::vector<Left> left_;
    std::size_t size_ = 0;  ///< of the file so far
};

/// Copied together.
std::vector<std::byte> joined(const Parts& parts);

/// Reads what may be anything: throws DamagedFile before it would read, or make room for, what isn't there.
class ArchiveReader {
public:
    /// Checks the frame and the checksum. `bytes` are the whole file and outlive the reader; with an `owner`,
    /// nobody changes them as long as that lives.
    ArchiveReader(std::span<const std::byte> bytes, const FileKind& kind,
                  std::shared_ptr<const void> owner = nullptr);

    template <Plain T>
    T take() {
        T value;
        std::memcpy(&value, take_bytes(sizeof value).data(), sizeof value);
        return value;
    }
    /// 0 or 1.
    bool take_flag();
    /// A number below `end`, such as an index; `what` names it when it isn't.
    std::uint32_t take_below(std::uint64_t end, const char* what);
    /// How many elements follow, each of which takes up no fewer than `least_bytes`.
    std::size_t take_count(std::size_t least_bytes);
    std::string take_text();
    /// As many elements as `put_all` put. The memory of Element is taken as it is: check what it holds.
    template <typename Element>
    std::vector<Element> take_all(std::size_t count) {
        const std::span<const std::byte> from = take_bytes_of(count, sizeof(Element));
        std::vector<Element> elements;
        elements.reserve(count);
        collision::prefer_large_pages(elements.data(), from.size());  // a third of the time would be faults
        elements.resize(count);
        if (count > 0) {
            std::memcpy(static_cast<void*>(elements.data()), from.data(), from.size());
        }
        return elements;
    }
    /// Likewise, from the next multiple of their alignment on. With an owner they stay where they are:
    /// nothing is copied.
    template <typename Element>
    collision::Storage<Element> take_aligned(std::size_t count) {
        align(alignof(Element));
        const std::byte* first = bytes_.data() + at_;
        if (owner_ == nullptr || reinterpret_cast<std::uintptr_t>(first) % alignof(Element) != 0) {
            return take_all<Element>(count);
        }
        take_bytes_of(count, sizeof(Element));
        return {std::span(reinterpret_cast<const Element*>(first), count), owner_};
    }
    /// Skips to the next multiple of `alignment`, counted from the file's start.
    void align(std::size_t alignment);
    std::span<const std::byte> take_bytes(std::size_t count);
    /// `count` times `size`.
    std::span<const std::byte> take_bytes_of(std::size_t count, std::size_t size);
    /// Throws if anything is left.
    void finish() const;

private:
    std::span<const std::byte> bytes_;
    std::shared_ptr<const void> owner_;  ///< null: what is taken is copied
    std::size_t at_ = kArchiveHeaderBytes;
};

}  // namespace campuswalk::scene
