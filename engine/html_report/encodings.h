#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct libdeflate_compressor;

namespace campuswalk::engine {

/// RFC 4648, with padding, without line ends.
std::string base64(std::string_view bytes);

/// Packs texts as RFC 1952 says, one after the other, in memory that it keeps. The same bytes give the same
/// file: no name and no time in it.
class Gzip {
public:
    /// `effort` from 1, the fastest, to 12.
    explicit Gzip(int effort);

    /// Valid until the next call.
    std::string_view pack(std::string_view bytes);

private:
    struct Free {
        void operator()(libdeflate_compressor* compressor) const;
    };

    std::unique_ptr<libdeflate_compressor, Free> compressor_;
    std::vector<char> packed_;
};

/// Text of an HTML element or of an attribute in double quotes. Bytes that aren't UTF-8 become U+FFFD.
std::string html_escaped(std::string_view text);

}  // namespace campuswalk::engine
