#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/html_report/encodings.h"
#include "engine/report/make_reporter.h"

namespace campuswalk::engine {

/// The program that shows a report in a browser, which is part of every report.
struct ViewerBundle {
    std::string_view script;  ///< contains neither `</script` nor `<!--`
    std::string_view style;   ///< contains no `</style`
};

/// An HTML file of chunks that the viewer unpacks, written front to back: what is written needs no memory.
/// The file loads nothing from anywhere, and its Content-Security-Policy allows only the viewer's own script
/// and style. Whatever files of users contain is in chunks, as base64: no text of theirs is markup.
class HtmlPage {
public:
    /// `bundle` must outlive it. Throws std::invalid_argument for one that would break the page.
    HtmlPage(TextSink sink, const ViewerBundle& bundle);

    void begin(std::string_view title);
    /// Compresses the bytes and returns the chunk's number.
    std::size_t add_data(std::string_view bytes);
    /// What is compressed already, as Gzip does it.
    std::size_t add_packed(std::string_view gzip);
    /// A picture as it is.
    std::size_t add_image(std::string_view bytes, std::string_view media_type);
    /// The last chunk, which lists what the others are, and the end.
    void finish(std::string_view index);

private:
    void add_chunk(const std::string& number, std::string_view attributes, std::string_view bytes);

    TextSink sink_;
    const ViewerBundle& bundle_;
    Gzip gzip_;
    std::size_t chunks_ = 0;
};

}  // namespace campuswalk::engine
