#include "engine/html_report/details_chunks.h"

#include <utility>

namespace campuswalk::engine {

namespace {

constexpr std::size_t kWalks = 16;
constexpr std::size_t kBytes = std::size_t{1} << 19U;

}  // namespace

void DetailsChunks::add(const std::string& line, std::string row, std::string& rows) {
    lines_ += line;
    lines_ += '\n';
    waiting_.push_back({std::move(row), &rows});
    if (waiting_.size() == kWalks || lines_.size() >= kBytes) {
        flush();
    }
}

void DetailsChunks::flush() {
    if (waiting_.empty()) {
        return;
    }
    const std::string chunk = std::to_string(page_.add_data(lines_));
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
        std::string& rows = *waiting_[i].rows;
        rows += (rows.empty() ? "" : ",\n") + waiting_[i].text + ",\"chunk\":" + chunk +
                ",\"line\":" + std::to_string(i) + "}";
    }
    lines_.clear();
    waiting_.clear();
}

}  // namespace campuswalk::engine
