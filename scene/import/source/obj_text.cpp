#include "scene/import/source/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "scene/base/ascii.h"

namespace campuswalk::scene {
namespace {

constexpr double kFloatRounding = 0x1p-24;  ///< unit roundoff of float32
constexpr double kMaxRounding = 0.00025;    ///< metres

/// `v`, three numbers, and the rest of the line.
struct VertexLine {
    Eigen::Vector3d at;
    std::string_view rest;
};

std::optional<double> take_number(std::string_view& text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return text.empty() || is_blank(text.front()) ? std::optional(number) : std::nullopt;
}

std::string_view without_indent(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) {
        line.remove_prefix(1);
    }
    return line;
}

bool is_vertex(std::string_view line) {
    return line.size() > 1 && line[0] == 'v' && is_blank(line[1]);
}

bool is_face(std::string_view line) {
    return line.size() > 1 && line[0] == 'f' && is_blank(line[1]);
}

bool is_uv(std::string_view line) {
    return line.starts_with("vt");
}

/// A face line without its second indices: `1/2/3` becomes `1//3`, `1/2` becomes `1`.
std::string without_uvs(std::string_view line) {
    std::string result;
    int slashes = 0;  // in the current vertex reference
    for (const char c : line) {
        slashes = is_blank(c) ? 0 : slashes + (c == '/' ? 1 : 0);
        if (slashes == 2 && c == '/') {
            result += "//";
        } else if (slashes != 1) {
            result += c;
        }
    }
    return result;
}

/// nullopt without three numbers, with a weight, or if the line continues in the next.
std::optional<VertexLine> read_vertex(std::string_view line) {
    VertexLine vertex;
    vertex.rest = line.substr(1);
    for (Eigen::Index k = 0; k < 3; ++k) {
        const std::optional<double> number = take_number(vertex.rest);
        if (!number) {
            return std::nullopt;
        }
        vertex.at[k] = *number;
    }
    std::string_view more = vertex.rest;
    const std::optional<double> weight = take_number(more);
    const bool weighted = weight && !take_number(more) && *weight != 1.0;
    return weighted || line.find('\\') != std::string_view::npos ? std::nullopt : std::optional(vertex);
}

/// Calls `visit(line)` for each line until it returns false; whether it never did.
template <typename Visit>
bool for_each_line(std::string_view text, const Visit& visit) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (!visit(text.substr(0, end))) {
            return false;
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return true;
}

bool is_coarse(const Eigen::Vector3d& at, double metres_per_unit) {
    return at.cwiseAbs().maxCoeff() * metres_per_unit * kFloatRounding > kMaxRounding;
}

/// Zero if moving gains nothing.
Eigen::Vector3d origin_of(std::string_view text, double metres_per_unit) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
    Eigen::Vector3d high = -low;
    const bool plain = for_each_line(text, [&](std::string_view line) {
        line = without_indent(line);
        if (!is_vertex(line)) {
            return true;
        }
        const std::optional<VertexLine> vertex = read_vertex(line);
        if (!vertex || !is_coarse(vertex->at, metres_per_unit)) {
            return false;  // all vertices have to be far
        }
        low = low.cwiseMin(vertex->at);
        high = high.cwiseMax(vertex->at);
        return true;
    });
    if (!plain || low.x() > high.x()) {
        return Eigen::Vector3d::Zero();
    }
    const double farthest = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
    const Eigen::Vector3d center = 0.5 * (low + high);
    const bool gains = (0.5 * (high - low)).maxCoeff() + 1.0 <= 0.5 * farthest;
    return gains ? Eigen::Vector3d(center.array().round()) : Eigen::Vector3d::Zero();
}

void append(std::vector<std::uint8_t>& to, std::string_view text) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());  // faster than characters
    to.insert(to.end(), bytes, bytes + text.size());
}

void append_moved(std::vector<std::uint8_t>& to, const VertexLine& vertex, const Eigen::Vector3d& origin) {
    append(to, "v");
    for (Eigen::Index k = 0; k < 3; ++k) {
        std::array<char, 64> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                       static_cast<float>(vertex.at[k] - origin[k]));
        append(to, " ");
        append(to, {digits.data(), static_cast<std::size_t>(end.ptr - digits.data())});
    }
    append(to, vertex.rest);
}

/// Up to LF, CR LF or CR.
std::string_view take_line(std::string_view& text) {
    const auto* end = std::ranges::find_if(text, [](char c) { return c == '\n' || c == '\r'; });
    const std::string_view line = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(line.size());
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
    return line;
}

std::string_view take_word(std::string_view& text) {
    text = without_indent(text);
    const auto* end = std::ranges::find_if(text, is_blank);
    const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(word.size());
    return word;
}

/// Whether a word begins like a number.
bool is_number(std::string_view word) {
    const bool is_signed = word.starts_with('-') || word.starts_with('+');
    word.remove_prefix(is_signed ? 1 : 0);
    const std::string_view digits = word.substr(word.starts_with('.') ? 1 : 0);
    double value = 0.0;  // of "nan" and "inf"
    return (!digits.empty() && is_digit(digits.front())) ||
           (!word.empty() && !is_signed && word.front() > '9' &&
            std::from_chars(word.data(), word.data() + word.size(), value).ec == std::errc());
}

/// Writes the lines of normalize_obj.
class Normalizer {
public:
    explicit Normalizer(std::size_t size) { text_.reserve(size + size / 8); }

    /// One that is joined already; false if it is faulty.
    bool add(std::string_view line) {
        const std::string_view whole = without_indent(line);
        const std::string_view keyword = take_word(line);
        if (keyword == "o" || keyword == "g") {
            add_object(keyword == "g", without_indent(line));
        } else if (keyword == "v" || keyword == "vt" || keyword == "vn") {
            return add_numbers(keyword, line);
        } else if (!keyword.empty()) {
            append(text_, whole);
            text_.push_back('\n');
        }
        return true;
    }

    std::vector<std::uint8_t> text() && { return std::move(text_); }

private:
    void add_object(bool is_group, std::string_view name) {
        while (!name.empty() && is_blank(name.back())) {
            name.remove_suffix(1);
        }
        if (name.empty() && !(is_group && grouped_)) {
            return;  // it ends no group
        }
        grouped_ = !name.empty() && (grouped_ || is_group);
        if (objects_ == 0 || name != name_) {
            name_ = name;
            append(text_, "g " + name_ + kObjectNumber + std::to_string(objects_++) + '\n');
        }
    }

    bool add_numbers(std::string_view keyword, std::string_view rest) {
        std::array<std::string_view, 7> words;
        std::size_t count = 0;
        while (count < words.size() && is_number(words[count] = take_word(rest))) {
            ++count;
        }
        const bool is_vertex = keyword == "v";
        if (is_vertex && count < 3) {
            return false;
        }
        // A vertex has a weight or a colour, but no part of one; what is more is no number of it.
        const std::size_t used = is_vertex ? (count > 6    ? 6
                                              : count == 5 ? 3
                                                           : count)
                                           : std::min<std::size_t>(count, 3);
        append(text_, keyword);
        for (std::size_t i = 0; i < used; ++i) {
            append(text_, words[i].starts_with('.') ? " 0" : " ");
            append(text_, words[i]);
        }
        append(text_, keyword == "vt" && used == 1 ? " 0\n" : "\n");  // assimp wants two
        return true;
    }

    std::vector<std::uint8_t> text_;
    std::string name_;  ///< of the current object
    std::size_t objects_ = 0;
    bool grouped_ = false;
};

/// Whether every `#` in the line begins a comment; in names, such as "Hall #2", only one between spaces does.
bool is_data(std::string_view line) {
    const std::string_view keyword = take_word(line);
    return keyword.empty() || keyword.front() == '#' || keyword.front() == 'v' || keyword == "f" ||
           keyword == "l" || keyword == "p" || keyword == "s";
}

}  // namespace

std::string normalize_obj(std::vector<std::uint8_t>& obj) {
    std::string_view text(reinterpret_cast<const char*>(obj.data()), obj.size());
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        return "it is UTF-16, and OBJ files are UTF-8";
    }
    text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    Normalizer normalizer(text.size());
    std::string joined;  // of lines that continue
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::string_view line = take_line(text);
        line = line.substr(0, line.find(is_data(joined.empty() ? line : joined) ? "#" : " # "));
        const bool continues = line.ends_with('\\') && !text.empty();
        line.remove_suffix(continues ? 1 : 0);
        if (continues || !joined.empty()) {
            joined += line;
            joined += continues ? " " : "";
        }
        if (continues) {
            continue;
        }
        if (!normalizer.add(joined.empty() ? line : joined)) {
            return "line " + std::to_string(number) + " has a vertex without three numbers";
        }
        joined.clear();
    }
    obj = std::move(normalizer).text();
    return "";
}

bool drop_absent_uvs(std::vector<std::uint8_t>& obj) {
    const std::string_view text(reinterpret_cast<const char*>(obj.data()), obj.size());
    bool named = false;
    const bool absent = for_each_line(text, [&](std::string_view line) {
        line = without_indent(line);
        named = named || (is_face(line) && without_uvs(line) != line);
        return !is_uv(line);
    });
    if (!absent || !named) {
        return false;
    }
    std::vector<std::uint8_t> result;
    result.reserve(obj.size());
    for_each_line(text, [&](std::string_view line) {
        if (is_face(without_indent(line))) {
            append(result, without_uvs(line));
        } else {
            append(result, line);
        }
        result.push_back('\n');
        return true;
    });
    obj = std::move(result);
    return true;
}

Eigen::Vector3d move_vertices_near(std::vector<std::uint8_t>& obj, double metres_per_unit) {
    const std::string_view text(reinterpret_cast<const char*>(obj.data()), obj.size());
    Eigen::Vector3d origin = origin_of(text, metres_per_unit);
    if (origin.isZero(0.0)) {
        return origin;
    }
    std::vector<std::uint8_t> moved;
    moved.reserve(obj.size());
    for_each_line(text, [&](std::string_view line) {
        const std::string_view plain = without_indent(line);
        const auto vertex = is_vertex(plain) ? read_vertex(plain) : std::nullopt;
        if (vertex) {
            append_moved(moved, *vertex, origin);
        } else {
            append(moved, line);
        }
        moved.push_back('\n');
        return true;
    });
    obj = std::move(moved);
    return origin;
}

}  // namespace campuswalk::scene
