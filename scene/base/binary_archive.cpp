#include "scene/base/binary_archive.h"

#include <utility>

#include "scene/base/checksum.h"

namespace campuswalk::scene {
namespace {

constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint32_t kOtherByteOrder = 0x04030201;

/// The first bytes of every file.
struct ArchiveHeader {
    std::array<char, 8> magic{};
    std::uint32_t byte_order = kByteOrder;
    std::uint32_t version = 0;
    std::uint64_t payload_bytes = 0;
    std::uint64_t checksum = 0;
    std::array<std::uint64_t, 4> zeros{};
};
static_assert(sizeof(ArchiveHeader) == kArchiveHeaderBytes);

}  // namespace

ArchiveWriter::ArchiveWriter(const FileKind& kind) {
    ArchiveHeader header;
    header.magic = kind.magic;
    header.version = kind.version;
    put_bytes(&header, sizeof header);
}

void ArchiveWriter::put_bytes(const void* from, std::size_t count) {
    const auto* first = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), first, first + count);
    size_ += count;
}

void ArchiveWriter::put_elements(std::span<const std::byte> elements) {
    constexpr std::size_t kBorrowedFrom = 64 << 10U;  // bytes; below that a copy is cheaper
    if (elements.size() < kBorrowedFrom) {
        put_bytes(elements.data(), elements.size());
    } else {
        borrowed_.push_back({bytes_.size(), elements});
        size_ += elements.size();
    }
}

void ArchiveWriter::put_text(std::string_view text) {
    put(std::uint64_t{text.size()});
    put_bytes(text.data(), text.size());
}

void ArchiveWriter::align(std::size_t alignment) {
    const std::size_t zeros = (alignment - size_ % alignment) % alignment;
    bytes_.resize(bytes_.size() + zeros);
    size_ += zeros;
}

BufferSequence ArchiveWriter::finish() {
    BufferSequence buffers;
    std::size_t done = kArchiveHeaderBytes;
    const std::span<const std::byte> bytes(bytes_);
    for (const Borrowed& borrowed : borrowed_) {
        buffers.push_back(bytes.subspan(done, borrowed.offset - done));
        buffers.push_back(borrowed.elements);
        done = borrowed.offset;
    }
    buffers.push_back(bytes.subspan(done));
    ArchiveHeader header;
    std::memcpy(&header, bytes_.data(), sizeof header);
    header.payload_bytes = size_ - kArchiveHeaderBytes;
    header.checksum = checksum_of(buffers);
    std::memcpy(bytes_.data(), &header, sizeof header);
    buffers.insert(buffers.begin(), bytes.first(kArchiveHeaderBytes));
    return buffers;
}

std::vector<std::byte> concatenated(const BufferSequence& buffers) {
    std::vector<std::byte> bytes;
    for (const std::span<const std::byte> buffer : buffers) {
        bytes.insert(bytes.end(), buffer.begin(), buffer.end());
    }
    return bytes;
}

ArchiveReader::ArchiveReader(std::span<const std::byte> bytes, const FileKind& kind,
                             std::shared_ptr<const void> owner)
    : bytes_(bytes), owner_(std::move(owner)) {
    ArchiveHeader header;
    if (bytes.size() < sizeof header) {
        throw DamagedFile("it is truncated");
    }
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.magic != kind.magic) {
        throw DamagedFile("it is another kind of file");
    }
    if (header.byte_order == kOtherByteOrder) {
        throw DamagedFile("it was written on a machine with a different byte order");
    }
    if (header.version != kind.version) {
        throw DamagedFile("it has version " + std::to_string(header.version) + ", not " +
                          std::to_string(kind.version));
    }
    if (header.payload_bytes > bytes.size() - kArchiveHeaderBytes) {
        throw DamagedFile("it is truncated");
    }
    if (header.payload_bytes < bytes.size() - kArchiveHeaderBytes) {
        throw DamagedFile("it has trailing bytes");
    }
    if (header.byte_order != kByteOrder || header.zeros != ArchiveHeader{}.zeros ||
        header.checksum != checksum_of(bytes.subspan(kArchiveHeaderBytes))) {
        throw DamagedFile("its checksum is wrong");
    }
}

std::span<const std::byte> ArchiveReader::take_bytes(std::size_t count, std::size_t size) {
    if (count > (bytes_.size() - at_) / size) {
        throw DamagedFile("it refers to data that it does not contain");
    }
    const std::span<const std::byte> taken = bytes_.subspan(at_, count * size);
    at_ += taken.size();
    return taken;
}

bool ArchiveReader::take_flag() {
    return take_below(2, "flag") == 1;
}

std::uint32_t ArchiveReader::take_below(std::uint64_t end, const char* what) {
    const auto value = take<std::uint32_t>();
    if (value >= end) {
        throw DamagedFile(std::string("a ") + what + " in it is out of range");
    }
    return value;
}

std::size_t ArchiveReader::take_count(std::size_t min_bytes) {
    const auto count = take<std::uint64_t>();
    if (count > (bytes_.size() - at_) / min_bytes) {
        throw DamagedFile("it refers to data that it does not contain");
    }
    return static_cast<std::size_t>(count);
}

std::string ArchiveReader::take_text() {
    const std::span<const std::byte> bytes = take_bytes(take_count(1));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void ArchiveReader::align(std::size_t alignment) {
    take_bytes((alignment - at_ % alignment) % alignment);
}

void ArchiveReader::finish() const {
    if (at_ != bytes_.size()) {
        throw DamagedFile("it contains data that nothing refers to");
    }
}

}  // namespace campuswalk::scene
