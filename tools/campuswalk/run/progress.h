#pragma once

#include <cstddef>

namespace campuswalk::tools {

/// A line on standard error that tells how far a run has come, and goes away again. For terminals alone.
class Progress {
public:
    Progress(bool wanted, std::size_t total);
    ~Progress() { hide(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void count(bool good);
    /// Draws it unless it stands there as it is.
    void show();
    /// Before anything else is printed.
    void hide();

private:
    bool wanted_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
    bool shown_ = false;
};

}  // namespace campuswalk::tools
