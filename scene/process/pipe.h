#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace campuswalk::scene {

/// A file descriptor that is closed by the destructor.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept;

    int number() const { return number_; }
    bool open() const { return number_ >= 0; }
    void close();

private:
    int number_;
};

/// A pipe. Started programs inherit neither end.
struct Pipe {
    Descriptor reading;
    Descriptor writing;
};

/// Throws std::system_error.
Pipe make_pipe();

/// /dev/null for writing.
Descriptor open_null_device();

// Signals don't interrupt these.

/// False if not everything could be written; errno says why.
bool write_all(int to, std::span<const std::byte> bytes);
bool write_all(int to, std::string_view text);

/// Waits for bytes and reads up to `buffer.size()` of them. Returns how many, 0 at the end of the file.
std::size_t read_some(int from, std::span<std::byte> buffer);

}  // namespace campuswalk::scene
