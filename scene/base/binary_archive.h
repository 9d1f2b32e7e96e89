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

/// A binary file is a header of 64 bytes (magic of its kind, byte order mark, version, payload size, payload
/// checksum, zeros) followed by the payload. Numbers are in native representation: a file is read only by
/// machines with the writer's byte order.

struct FileKind {
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
};

/// A file that is damaged, forged, of another kind or of another version. `what()` tells the user which, such
/// as "it is truncated".
class DamagedFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t kArchiveHeaderBytes = 64;

/// Types whose object representation is stored.
template <typename T>
concept Plain = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

/// The bytes of a file in order, scattered over several buffers.
using BufferSequence = std::vector<std::span<const std::byte>>;

class ArchiveWriter {
public:
    explicit ArchiveWriter(const FileKind& kind);

    template <Plain T>
    void put(T value) {
        put_bytes(&value, sizeof value);
    }
    void put_text(std::string_view text);
    /// The elements without their count. Large spans are not copied: they must stay valid until the file is
    /// written.
    template <typename Element>
    void put_all(std::span<const Element> elements) {
        put_elements(std::as_bytes(elements));
    }
    /// As put_all, after padding to the alignment of Element.
    template <typename Element>
    void put_aligned(std::span<const Element> elements) {
        align(alignof(Element));
        put_all(elements);
    }
    /// Completes the header. The buffers point into the writer and into the spans that were put; nothing may
    /// be put afterwards.
    BufferSequence finish();

private:
    /// Elements that were not copied, and their offset in `bytes_`.
    struct Borrowed {
        std::size_t offset = 0;
        std::span<const std::byte> elements;
    };

    /// Pads with zeros to a multiple of `alignment` from the start of the file.
    void align(std::size_t alignment);
    void put_bytes(const void* from, std::size_t count);
    void put_elements(std::span<const std::byte> elements);

    std::vector<std::byte> bytes_;  ///< the file without what is borrowed
    std::vector<Borrowed> borrowed_;
    std::size_t size_ = 0;  ///< of the file so far, bytes
};

std::vector<std::byte> concatenated(const BufferSequence& buffers);

/// Reads untrusted bytes: throws DamagedFile before it reads past their end or allocates more than they hold.
class ArchiveReader {
public:
    /// Checks the header and the checksum. `bytes` are the whole file and outlive the reader. With an
    /// `owner`, they stay valid and unchanged as long as the owner lives.
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
    /// An index or enumerator below `end`; `what` names it in the exception.
    std::uint32_t take_below(std::uint64_t end, const char* what);
    /// The count of elements that follow, each of at least `min_bytes`.
    std::size_t take_count(std::size_t min_bytes);
    std::string take_text();
    /// The inverse of put_all. Values are not validated.
    template <typename Element>
    std::vector<Element> take_all(std::size_t count) {
        const std::span<const std::byte> from = take_bytes(count, sizeof(Element));
        std::vector<Element> elements;
        elements.reserve(count);
        collision::prefer_large_pages(elements.data(),
                                      from.size());  // else a third of the time goes to page faults
        elements.resize(count);
        if (count > 0) {
            std::memcpy(static_cast<void*>(elements.data()), from.data(), from.size());
        }
        return elements;
    }
    /// The inverse of put_aligned. With an owner the elements are not copied but referred to.
    template <typename Element>
    collision::Storage<Element> take_aligned(std::size_t count) {
        align(alignof(Element));
        const std::byte* first = bytes_.data() + at_;
        if (owner_ == nullptr || reinterpret_cast<std::uintptr_t>(first) % alignof(Element) != 0) {
            return take_all<Element>(count);
        }
        take_bytes(count, sizeof(Element));
        return {std::span(reinterpret_cast<const Element*>(first), count), owner_};
    }
    /// Throws if bytes are left.
    void finish() const;

private:
    /// Skips to a multiple of `alignment` from the start of the file.
    void align(std::size_t alignment);
    /// `count` * `size` bytes.
    std::span<const std::byte> take_bytes(std::size_t count, std::size_t size = 1);

    std::span<const std::byte> bytes_;
    std::shared_ptr<const void> owner_;  ///< null: elements are copied
    std::size_t at_ = kArchiveHeaderBytes;
};

}  // namespace campuswalk::scene
