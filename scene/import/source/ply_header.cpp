#include "scene/import/source/ply_header.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <sstream>
#include <string_view>
#include <utility>

namespace campuswalk::scene {

namespace {

constexpr std::size_t kMaxHeader = std::size_t{1} << 20U;

/// Bytes of a binary value; 1 for an unknown type, which the reader reports.
std::size_t size_of(std::string_view type) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 12> kSizes = {{{"short", 2},
                                                                                  {"ushort", 2},
                                                                                  {"int16", 2},
                                                                                  {"uint16", 2},
                                                                                  {"int", 4},
                                                                                  {"uint", 4},
                                                                                  {"int32", 4},
                                                                                  {"uint32", 4},
                                                                                  {"float", 4},
                                                                                  {"float32", 4},
                                                                                  {"double", 8},
                                                                                  {"float64", 8}}};
    for (const auto& [name, size] : kSizes) {
        if (name == type) {
            return size;
        }
    }
    return 1;
}

/// The fewest bytes that the elements of a header take.
class LeastSize {
public:
    void add_line(const std::string& line) {
        std::istringstream words(line);
        std::string keyword;
        std::string first;
        std::string second;
        words >> keyword >> first >> second;
        if (keyword == "format") {
            is_text_ = first == "ascii";
        } else if (keyword == "element") {
            finish_element();
            const char* end = second.data() + second.size();
            if (std::from_chars(second.data(), end, count_).ec == std::errc::result_out_of_range) {
                count_ = UINT64_MAX;
            }
        } else if (keyword == "property") {
            constexpr std::uint64_t kDigitAndSpace = 2;
            bytes_each_ += is_text_ ? kDigitAndSpace : size_of(first == "list" ? second : first);
        }
    }

    /// Whether so many bytes can hold all elements.
    bool fits(std::uint64_t bytes) {
        finish_element();
        const std::uint64_t last_line_end = is_text_ ? 1 : 0;
        return bytes_ <= static_cast<double>(bytes + last_line_end);
    }

private:
    void finish_element() {
        bytes_ += static_cast<double>(std::exchange(count_, 0)) *
                  static_cast<double>(std::exchange(bytes_each_, 0));
    }

    bool is_text_ = false;
    std::uint64_t count_ = 0;
    std::uint64_t bytes_each_ = 0;
    double bytes_ = 0.0;  // a product of two counts may exceed any integer
};

}  // namespace

std::string ply_fault(std::istream& in) {
    in.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(in.tellg());
    in.seekg(0);
    LeastSize least;
    std::uint64_t read = 0;
    for (std::string line; read < kMaxHeader && std::getline(in, line);) {
        read += line.size() + 1;
        if (line.starts_with("end_header")) {
            return least.fits(read < size ? size - read : 0)
                       ? ""
                       : "it ends before the elements that its header announces";
        }
        least.add_line(line);
    }
    return "it ends inside its PLY header";
}

}  // namespace campuswalk::scene
