#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "tools/campuswalk/base/status_line.h"

namespace campuswalk::tools {

/// Such as "[####....] ". `share` is from 0 to 1.
std::string progress_bar(double share);

/// Shows the progress of a run in a status line.
class Progress {
public:
    Progress(bool enabled, std::size_t total);

    void count(bool good);
    /// Shows that a walk has reached `seconds` of simulated time, of the `planned` ones if these are known.
    void walk_is_at(std::string_view walk, double seconds, std::optional<double> planned);
    /// Draws the line unless it is shown already.
    void show();
    /// Erases the line; to be called before anything else is printed.
    void hide() { status_.hide(); }

private:
    std::string line() const;

    StatusLine status_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
    std::string walk_;             ///< the latest one, and how far it is
    std::optional<double> share_;  ///< of the latest walk: the part that is done
};

}  // namespace campuswalk::tools
