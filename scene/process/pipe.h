#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace campuswalk::scene {

/// A file descriptor, closed in the end.
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

/// Programs that are started inherit neither end.
struct Pipe {
    Descriptor reading;
    Descriptor writing;
};

/// Throws std::system_error.
Pipe make_pipe();

/// /dev/null, to write to.
Descriptor open_nowhere();

// A signal interrupts neither of these.

/// False when not all of it could be written; errno says why.
bool write_all(int to, std::span<const std::byte> bytes);
bool write_all(int to, std::string_view text);

/// Waits until there is something and reads that, as far as there is room: the number of bytes, 0 when there
/// will be no more.
std::size_t read_some(int from, std::span<std::byte> room);

}  // namespace campuswalk::scene
