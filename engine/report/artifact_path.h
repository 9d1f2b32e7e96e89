#pragma once

#include <string>
#include <string_view>

namespace campuswalk::engine {

// Reports name a run's files for programs that open them: Jenkins, GitLab, the maker of HTML reports. Such a
// path must lead into the run's output folder and mean the same to all of them.

/// Whether it is relative and stays inside: non-empty parts between `/`, none of which begins with a dot (as
/// `..` and `.git` do), no drive, no `\` or `|`, no `[[` or `]]`, valid UTF-8, and no character that changes
/// how others are shown.
bool is_artifact_path(std::string_view path);

/// A path below the output folder in that form: what it can't have is percent-encoded (`%5D`), and so is a
/// `%` that would look like it, so that different paths stay different. Most paths stay as they are.
std::string to_artifact_path(std::string_view path);

/// Each byte as `%5D`.
std::string percent_encoded(std::string_view bytes);

/// Whether it is of the form `image/png`.
bool is_media_type(std::string_view text);

}  // namespace campuswalk::engine
