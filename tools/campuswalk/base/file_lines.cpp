#include "tools/campuswalk/base/file_lines.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "scene/base/why_unreadable.h"
#include "scene/process/pipe.h"
#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

scene::InputError long_line(const std::filesystem::path& file, int number) {
    return {{file.generic_string(), number, 1},
            "long-line",
            "this line is longer than " + std::to_string(kLongestLine) +
                " bytes, the limit; name a file that campuswalk wrote"};
}

FileLines::FileLines(std::filesystem::path file, std::size_t block_bytes, std::uintmax_t offset)
    : file_(std::move(file)), block_bytes_(block_bytes), next_block_(offset), begin_(offset) {
    if (const std::string why = scene::why_unreadable(file_); !why.empty()) {
        throw error_about(file_, "missing-file", why);
    }
}

std::optional<std::string_view> FileLines::next() {
    begin_ = end();
    std::size_t searched = used_;
    while (true) {
        const std::size_t end = std::min(block_.find('\n', searched), block_.size());
        if (end - used_ > kLongestLine) {
            throw long_line(file_, number_ + 1);
        }
        if (end < block_.size()) {
            const std::string_view line = std::string_view(block_).substr(used_, end - used_);
            used_ = end + 1;
            ++number_;
            return line;
        }
        block_.erase(0, used_);
        used_ = 0;
        searched = block_.size();
        if (!read_block()) {
            return std::nullopt;
        }
    }
}

/// Fills the block up, or makes it longer for a line that doesn't fit.
bool FileLines::read_block() {
    const scene::Descriptor file(::open(file_.c_str(), O_RDONLY | O_CLOEXEC));
    const std::size_t before = block_.size();
    block_.resize(before < block_bytes_ / 2 ? block_bytes_ : before + std::max(before, block_bytes_));
    const ssize_t count = file.open() ? ::pread(file.number(), block_.data() + before, block_.size() - before,
                                                static_cast<off_t>(next_block_))
                                      : -1;
    if (count < 0) {
        throw error_about(file_, "missing-file",
                          "it can't be read any more: " + std::generic_category().message(errno));
    }
    block_.resize(before + static_cast<std::size_t>(count));
    next_block_ += static_cast<std::uintmax_t>(count);
    return count > 0;
}

}  // namespace campuswalk::tools
