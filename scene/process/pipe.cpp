#include "scene/process/pipe.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace campuswalk::scene {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    if (this != &other) {
        close();
        number_ = std::exchange(other.number_, -1);
    }
    return *this;
}

void Descriptor::close() {
    if (open()) {
        ::close(std::exchange(number_, -1));
    }
}

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw std::system_error(errno, std::generic_category());
    }
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Descriptor open_null_device() {
    return Descriptor(::open("/dev/null", O_WRONLY | O_CLOEXEC));
}

bool write_all(int to, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(to, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes = bytes.subspan(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return true;
}

bool write_all(int to, std::string_view text) {
    return write_all(to, std::as_bytes(std::span(text)));
}

std::size_t read_some(int from, std::span<std::byte> buffer) {
    ssize_t got = 0;
    do {
        got = read(from, buffer.data(), buffer.size());
    } while (got < 0 && errno == EINTR);
    return got > 0 ? static_cast<std::size_t>(got) : 0;
}

}  // namespace campuswalk::scene
