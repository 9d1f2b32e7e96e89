#pragma once

#include <string>
#include <vector>

#include "engine/html_report/html_page.h"

namespace campuswalk::engine {

/// Collects what a report says of walks, one per line, in chunks of a size that a browser unpacks at once.
/// Rows of the index get the chunk and line of their details when the chunk is written.
class DetailsChunks {
public:
    /// `page` must outlive it.
    explicit DetailsChunks(HtmlPage& page) : page_(page) {}

    /// `line` has no line end. `row` comes from open_walk_row and is completed and appended to `rows`, a
    /// list's items without its brackets, which must outlive this.
    void add(const std::string& line, std::string row, std::string& rows);
    /// Writes what is left.
    void flush();

private:
    struct Row {
        std::string text;
        std::string* rows = nullptr;
    };

    HtmlPage& page_;
    std::string lines_;
    std::vector<Row> waiting_;
};

}  // namespace campuswalk::engine
