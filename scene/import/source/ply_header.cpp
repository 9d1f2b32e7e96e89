#include "scene/import/source/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

namespace campuswalk::scene {

namespace {

constexpr std::size_t kMaxHeader = std::size_t{1} << 20U;
constexpr std::string_view kSpace = " \t\r";

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

/// A kind of element, each of which has a line in a text file.
struct Element {
    std::uint64_t count = 0;
    std::vector<bool> is_list;  ///< of each property
};

/// Whether lists are as long as they say: assimp fills one up with zeros, to a polygon of thousands of
/// corners.
bool lists_fit_line(std::string_view line, const Element& element) {
    const auto take_word = [&line] {
        line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(kSpace));
        line.remove_prefix(word.size());
        return word;
    };
    for (const bool is_list : element.is_list) {
        const std::string_view word = take_word();
        double count = 0.0;  // other formats than whole numbers are valid, and read by assimp
        if (is_list && std::from_chars(word.data(), word.data() + word.size(), count).ec == std::errc()) {
            const double most = static_cast<double>(line.size()) + 1.0;  // more than it can hold
            const std::size_t wanted = count >= 1.0 ? static_cast<std::size_t>(std::min(count, most)) : 0;
            for (std::size_t i = 0; i < wanted; ++i) {
                if (take_word().empty()) {
                    return false;
                }
            }
        }
    }
    return true;
}

/// What a header says of the elements behind it.
class Elements {
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
            all_.push_back({count_, {}});
        } else if (keyword == "property") {
            if (!all_.empty()) {
                all_.back().is_list.push_back(first == "list");
            }
            constexpr std::uint64_t kDigitAndSpace = 2;
            bytes_each_ += is_text_ ? kDigitAndSpace : size_of(first == "list" ? second : first);
        }
    }

    /// Whether the lists of a text file, which follow, are as long as they say.
    bool lists_fit(std::istream& in) const {
        std::string line;
        for (const Element& element :
             is_text_ ? std::span<const Element>(all_) : std::span<const Element>()) {
            for (std::uint64_t i = 0; i < element.count && std::getline(in, line); ++i) {
                if (line.find_first_not_of(kSpace) == std::string::npos) {
                    return true;  // readers differ in whether such a line is an element
                }
                if (!lists_fit_line(line, element)) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Whether so many bytes can hold all elements.
    bool fits(std::uint64_t bytes) {
        finish_element();
        const std::uint64_t last_line_end = is_text_ ? 1 : 0;
        return bytes_ <= static_cast<double>(bytes + last_line_end);
    }

private:
    void finish_element() {
        // Those without properties take a line in a text file, and are refused in others: else any
        // number would fit.
        const std::uint64_t bytes_each = std::max<std::uint64_t>(std::exchange(bytes_each_, 0), 1);
        bytes_ += static_cast<double>(std::exchange(count_, 0)) * static_cast<double>(bytes_each);
    }

    bool is_text_ = false;
    std::vector<Element> all_;
    std::uint64_t count_ = 0;
    std::uint64_t bytes_each_ = 0;
    double bytes_ = 0.0;  // a product of two counts may exceed any integer
};

/// A number of a binary list's length.
std::uint64_t length_of(std::string_view bytes, bool big_endian) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const char byte = bytes[big_endian ? i : bytes.size() - 1 - i];
        value = value << 8U | static_cast<std::uint8_t>(byte);
    }
    return value;
}

/// A kind of element, with its part of the header and of the data.
struct Section {
    struct Property {
        std::size_t size = 0;         ///< of a value
        std::size_t length_size = 0;  ///< of a list's length; zero without a list
    };

    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
    std::string header;
    std::string data;

    bool is_geometry() const { return name == "vertex" || name == "face" || name == "tristrips"; }

    /// Takes its elements from the front of the data behind the header, each with something before it.
    void take_data(std::string_view& all, std::string_view format, std::string_view before) {
        for (std::uint64_t i = 0; i < count && !all.empty(); ++i) {
            const std::size_t size =
                format == "ascii" ? line_size(all) : values_size(all, format == "binary_big_endian");
            data += before;
            data += all.substr(0, size);
            all.remove_prefix(std::min(size, all.size()));
        }
    }

private:
    std::size_t line_size(std::string_view all) const {
        // An empty line is an element only without properties.
        const std::size_t text = properties.empty() ? 0 : all.find_first_not_of(" \t\r\n");
        const std::size_t end = all.find('\n', std::min(text, all.size()));
        return end == std::string_view::npos ? all.size() : end + 1;
    }
    std::size_t values_size(std::string_view all, bool big_endian) const {
        std::size_t at = 0;
        for (const Property& property : properties) {
            const std::uint64_t length =
                property.length_size == 0
                    ? 1
                    : length_of(all.substr(std::min(at, all.size()), property.length_size), big_endian);
            at = length > all.size() ? all.size() : at + property.length_size + length * property.size;
        }
        return at;
    }
};

/// The header's lines by element; the first, without a name, has what is before, and all comments.
struct Header {
    std::string format;
    std::vector<Section> sections{1};
    bool has_late_comments = false;

    explicit Header(std::istream& in) {
        std::string line;
        while (std::getline(in, line) && line.substr(0, line.find_last_not_of(kSpace) + 1) != "end_header") {
            add_line(line.substr(0, line.find_last_not_of(kSpace) + 1));
        }
    }

private:
    void add_line(const std::string& line) {
        std::istringstream words(line);
        std::string keyword;
        std::string first;
        std::string second;
        std::string third;
        words >> keyword >> first >> second >> third;
        if (keyword == "comment" || keyword == "obj_info") {
            has_late_comments = has_late_comments || sections.size() > 1;
            sections.front().header += line + '\n';
            return;
        }
        if (keyword == "format") {
            format = first;
        } else if (keyword == "element") {
            sections.emplace_back().name = first;
            std::from_chars(second.data(), second.data() + second.size(), sections.back().count);
        } else if (keyword == "property" && first == "list") {
            sections.back().properties.push_back({size_of(third), size_of(second)});
        } else if (keyword == "property") {
            sections.back().properties.push_back({size_of(first), 0});
        }
        sections.back().header += line + '\n';
    }
};

}  // namespace

std::vector<std::uint8_t> rewrite_ply(std::istream& in) {
    Header header(in);
    std::vector<Section>& sections = header.sections;
    const auto last = std::find_if(sections.rbegin(), sections.rend(), [](const Section& section) {
                          return section.is_geometry();
                      }).base();
    sections.erase(last, sections.end());
    const auto is_other = [](const Section& section) { return !section.is_geometry(); };
    const int first_byte = in.peek();
    const bool is_binary = header.format != "ascii";
    const bool line_end = is_binary && (first_byte == '\n' || first_byte == '\r');
    if (sections.empty() || (!header.has_late_comments && !line_end &&
                             std::none_of(sections.begin() + 1, sections.end(), is_other))) {
        return {};
    }
    const std::string all(std::istreambuf_iterator<char>(in), {});
    std::string_view rest = all;
    std::string text = sections.front().header;
    std::string data;
    bool pad = is_binary;  // the first with geometry
    for (Section& section : std::span(sections).subspan(1)) {
        section.take_data(rest, header.format, section.is_geometry() && pad ? std::string_view("\0", 1) : "");
        if (section.is_geometry()) {
            section.header.insert(section.header.find('\n') + 1, pad ? "property uchar padding\n" : "");
            pad = false;
            text += section.header;
            data += section.data;
        }
    }
    text += "end_header\n" + data;
    return {text.begin(), text.end()};
}

std::string ply_fault(std::istream& in) {
    in.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(in.tellg());
    in.seekg(0);
    Elements elements;
    std::uint64_t read = 0;
    for (std::string line; read < kMaxHeader && std::getline(in, line);) {
        read += line.size() + 1;
        if (line.substr(0, line.find_last_not_of(kSpace) + 1) == "end_header") {
            if (!elements.fits(read < size ? size - read : 0)) {
                return "it ends before the elements that its header announces";
            }
            return elements.lists_fit(in) ? "" : "a list announces more numbers than its line holds";
        }
        elements.add_line(line);
    }
    return "it ends inside its PLY header";
}

}  // namespace campuswalk::scene
