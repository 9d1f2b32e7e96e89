#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace campuswalk::tools {

/// A line on standard error that tells how far a run has come, and goes away again. For terminals alone.
class Progress {
public:
    Progress(bool wanted, std::size_t total);
    ~Progress() { hide(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void count(bool good);
    /// A walk that takes long enough to be asked for has come to this simulated time, of so much that is
    /// planned; none where that can't be known.
    void walk_is_at(std::string_view walk, double seconds, std::optional<double> planned);
    /// Draws it unless it stands there as it is.
    void show();
    /// Before anything else is printed.
    void hide();

private:
    std::string line() const;

    bool mode_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
    std::string walk_;             ///< that was heard of last, and where it is
    std::optional<double> share_;  ///< of it that is done
    bool shown_ = false;
};

}  // namespace campuswalk::tools
