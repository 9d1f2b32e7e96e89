#pragma once

#include <string>
#include <string_view>

namespace campuswalk::engine {

/// RFC 4648, with padding, without line ends.
std::string base64(std::string_view bytes);

/// RFC 1952. The same bytes give the same file: no name and no time in it.
/// `effort` from 1, the fastest, to 12.
std::string gzip(std::string_view bytes, int effort = 6);

/// Text of an HTML element or of an attribute in double quotes. Bytes that aren't UTF-8 become U+FFFD.
std::string html_escaped(std::string_view text);

}  // namespace campuswalk::engine
