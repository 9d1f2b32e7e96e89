#include "scene/osm/geometry/heights.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "scene/base/ascii.h"
#include "scene/base/why_unreadable.h"

namespace campuswalk::scene::osm {
namespace {

constexpr std::size_t kMaxPoints = 100'000'000;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Heights at points of a grid in degrees, row by row from the north-west.
struct Grid {
    std::size_t columns = 0;
    std::size_t rows = 0;
    double west = 0.0;           ///< of the first column's points
    double south = 0.0;          ///< of the last row's points
    double step = 0.0;           ///< degrees
    std::vector<float> heights;  ///< NaN: unknown

    /// NaN outside, or where one of the four points around is unknown.
    double at(double latitude, double longitude) const {
        constexpr double kSlack = 1e-6;
        const double first = west - kSlack * step;
        const double turn = longitude < first ? 360.0 : longitude >= first + 360.0 ? -360.0 : 0.0;
        const double x = (longitude + turn - west) / step;
        const double y = static_cast<double>(rows - 1) - (latitude - south) / step;
        if (!(x >= -kSlack && y >= -kSlack && x <= static_cast<double>(columns - 1) + kSlack &&
              y <= static_cast<double>(rows - 1) + kSlack)) {
            return kNone;
        }
        const auto column = std::min(static_cast<std::size_t>(std::max(0.0, x)), columns - 2);
        const auto row = std::min(static_cast<std::size_t>(std::max(0.0, y)), rows - 2);
        const double u = std::clamp(x - static_cast<double>(column), 0.0, 1.0);
        const double v = std::clamp(y - static_cast<double>(row), 0.0, 1.0);
        const auto height = [&](std::size_t c, std::size_t r) {
            return static_cast<double>(heights[r * columns + c]);
        };
        return (1 - v) * ((1 - u) * height(column, row) + u * height(column + 1, row)) +
               v * ((1 - u) * height(column, row + 1) + u * height(column + 1, row + 1));
    }
};

[[noreturn]] void refuse(const SourceMark& mark, int line, const std::string& why) {
    SourceMark at = mark;
    at.line = line;
    throw InputError(at, "bad-heights", why);
}

/// Words of a text file with their lines.
class Words {
public:
    explicit Words(std::istream& in) : in_(in) {}

    bool next(std::string& word) {
        word.clear();
        for (int c = in_.get(); c != EOF; c = in_.get()) {
            const bool space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
            if (space && !word.empty()) {
                in_.unget();
                return true;
            }
            line_ += c == '\n' ? 1 : 0;
            if (!space) {
                word += static_cast<char>(c);
                if (word.size() > 64) {
                    return false;
                }
            }
        }
        return !word.empty();
    }
    int line() const { return line_; }

private:
    std::istream& in_;
    int line_ = 1;
};

bool number_from(const std::string& word, double& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

/// A height of an ASCII grid; NaN, as GDAL writes it, where there is none.
bool height_from(const std::string& word, double& value) {
    if (word == "nan" || word == "NaN" || word == "-nan") {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    return number_from(word, value);
}

/// Digits only, as in N48E011.
bool degrees_from(const std::string& digits, double& value) {
    return std::ranges::all_of(digits, is_digit) && number_from(digits, value);
}

Grid read_ascii_grid(std::istream& in, const SourceMark& mark) {
    constexpr std::array<const char*, 6> kKeys = {"ncols",     "nrows",    "xllcorner",
                                                  "yllcorner", "cellsize", "nodata_value"};
    Words words(in);
    std::array<double, 6> values = {0, 0, 0, 0, 0, -9999};
    bool centers = false;
    std::string word;
    std::vector<float> heights;
    while (words.next(word)) {
        double value = 0.0;
        if (height_from(word, value)) {
            heights.push_back(static_cast<float>(value));
            break;
        }
        word = to_lower(word);
        if (word == "xllcenter" || word == "yllcenter") {
            centers = true;
            word = word == "xllcenter" ? "xllcorner" : "yllcorner";
        }
        const auto* key = std::ranges::find(kKeys, word);
        const int line = words.line();
        const bool valid = key != kKeys.end() && words.next(word) &&
                           (key == kKeys.end() - 1 ? height_from(word, value) : number_from(word, value));
        if (!valid) {
            refuse(mark, line,
                   "it is no Esri ASCII grid: ncols, nrows, xllcorner, yllcorner and cellsize come first");
        }
        values[static_cast<std::size_t>(key - kKeys.begin())] = value;
    }
    const double columns = values[0];
    const double rows = values[1];
    if (!(columns >= 2 && rows >= 2 && columns * rows <= static_cast<double>(kMaxPoints)) ||
        columns != std::floor(columns) || rows != std::floor(rows) || !(values[4] > 0.0)) {
        refuse(mark, words.line(),
               "its ncols, nrows or cellsize can't be: a grid has 2 by 2 to 100 million points");
    }
    if (!(values[4] < 1.0 && std::abs(values[2]) <= 360.0 && std::abs(values[3]) <= 90.0)) {
        refuse(mark, words.line(),
               "its coordinates aren't degrees; convert it to WGS 84 (gdalwarp -t_srs EPSG:4326)");
    }
    Grid grid;
    grid.columns = static_cast<std::size_t>(columns);
    grid.rows = static_cast<std::size_t>(rows);
    grid.step = values[4];
    grid.west = values[2] + (centers ? 0.0 : 0.5 * grid.step);
    grid.south = values[3] + (centers ? 0.0 : 0.5 * grid.step);
    const std::size_t count = grid.columns * grid.rows;
    double value = 0.0;
    while (heights.size() < count && words.next(word)) {
        if (!height_from(word, value)) {
            refuse(mark, words.line(), "a height isn't a number");
        }
        heights.push_back(static_cast<float>(value));
    }
    if (heights.size() < count) {
        refuse(
            mark, words.line(),
            "it ends after " + std::to_string(heights.size()) + " of " + std::to_string(count) + " heights");
    }
    std::ranges::replace(heights, static_cast<float>(values[5]), std::numeric_limits<float>::quiet_NaN());
    grid.heights = std::move(heights);
    return grid;
}

Grid read_srtm_tile(std::istream& in, std::uintmax_t size, const std::string& name, const SourceMark& mark) {
    constexpr std::uintmax_t kThreeSeconds = 1201;
    constexpr std::uintmax_t kOneSecond = 3601;
    Grid grid;
    grid.columns = size == 2 * kThreeSeconds * kThreeSeconds ? kThreeSeconds
                   : size == 2 * kOneSecond * kOneSecond     ? kOneSecond
                                                             : 0;
    grid.rows = grid.columns;
    double south = 0.0;
    double west = 0.0;
    const bool named = name.size() >= 7 && (name[0] == 'N' || name[0] == 'S') &&
                       (name[3] == 'E' || name[3] == 'W') && degrees_from(name.substr(1, 2), south) &&
                       degrees_from(name.substr(4, 3), west);
    if (grid.columns == 0 || !named) {
        refuse(mark, 0,
               "it is no tile of SRTM: these have 1201 by 1201 or 3601 by 3601 heights and names such as "
               "N48E011.hgt");
    }
    grid.south = name[0] == 'N' ? south : -south;
    grid.west = name[3] == 'E' ? west : -west;
    grid.step = 1.0 / static_cast<double>(grid.columns - 1);
    std::vector<unsigned char> bytes(size);
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    grid.heights.resize(grid.columns * grid.rows);
    for (std::size_t i = 0; i < grid.heights.size(); ++i) {
        const auto height = static_cast<std::int16_t>((bytes[2 * i] << 8U) | bytes[2 * i + 1]);
        constexpr std::int16_t kVoid = -32768;
        grid.heights[i] =
            height == kVoid ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(height);
    }
    return grid;
}

Grid read_grid(const std::filesystem::path& file, const SourceMark& mark) {
    if (const std::string why = why_unreadable(file); !why.empty()) {
        throw InputError(mark, "missing-file", why);
    }
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::ifstream in(file, std::ios::binary);
    if (error || !in) {
        throw InputError(mark, "missing-file", "it can't be read");
    }
    const std::filesystem::path given = mark.file;  // `file` may be what a link of that name leads to
    const std::string extension = given.extension().string();
    if (extension == ".hgt" || extension == ".HGT") {
        return read_srtm_tile(in, size, given.filename().string(), mark);
    }
    if (extension == ".asc" || extension == ".ASC") {
        return read_ascii_grid(in, mark);
    }
    refuse(mark, 0, "heights come as .asc (Esri ASCII grid) or .hgt (SRTM)");
}

}  // namespace

Terrain read_heights(const std::filesystem::path& file, const SourceMark& mark, const Map& map,
                     const Box& box) {
    const Grid grid = read_grid(file, mark);
    const double middle_latitude = 0.5 * (map.geographic.south + map.geographic.north);
    const double middle_longitude = 0.5 * (map.geographic.west + map.geographic.east);
    const Projection projection(middle_latitude, middle_longitude);
    const double degrees_north = 0.001 / projection.project(middle_latitude + 0.001, middle_longitude).y();
    const double cell = std::clamp(grid.step / degrees_north, 2.0, 20.0);
    const double reference = grid.at(middle_latitude, middle_longitude);
    const Point size = box.size() / cell;
    const auto columns = static_cast<std::size_t>(std::ceil(size.x())) + 1;
    const auto rows = static_cast<std::size_t>(std::ceil(size.y())) + 1;
    std::vector<double> heights;
    heights.reserve(columns * rows);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const Point p = box.min + cell * Point(static_cast<double>(column), static_cast<double>(row));
            const GeographicPoint at = projection.unproject(p);
            const double height = grid.at(at.latitude_deg, at.longitude_deg) - reference;
            if (!std::isfinite(height) || std::abs(height) > 10'000.0) {
                refuse(mark, 0,
                       "it has no heights for a part of the map, or impossible ones; it must cover " +
                           std::to_string(map.geographic.south) + "," + std::to_string(map.geographic.west) +
                           "," + std::to_string(map.geographic.north) + "," +
                           std::to_string(map.geographic.east) + " and 300 m around");
            }
            heights.push_back(height);
        }
    }
    return Terrain(box.min, cell, std::max<std::size_t>(columns, 2), std::move(heights));
}

}  // namespace campuswalk::scene::osm
