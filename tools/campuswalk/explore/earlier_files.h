#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

namespace campuswalk::tools::explore {

/// The first line of each walk of `--write-walks`, behind the finding's number.
inline constexpr const char* kWalkHeading = " of `campuswalk explore`. ";

// A later run has other findings and storeys: what an earlier one left in the folder would be taken for its
// own. Only what `explore` wrote itself is removed.

/// Whether there is no such file, or it is a walk of this campus that `explore` has written and that is as it
/// was.
bool may_replace_walk(const std::filesystem::path& file, const std::string& campus);

/// Removes the walks of this campus (as it stands in them) that aren't `written`, names of files, and that
/// still are as they were: with their heading and expected to fail. A walk whose `status` was taken away has
/// become a test, and stays.
void remove_earlier_walks(const std::filesystem::path& folder, const std::string& campus,
                          const std::set<std::string>& written);

/// Removes storey-N.png for each N from `count` on, if it says inside that it is a plan of campuswalk.
void remove_earlier_plans(const std::filesystem::path& folder, std::size_t count);

}  // namespace campuswalk::tools::explore
