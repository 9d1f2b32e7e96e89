#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace campuswalk::scene::test {

/// OpenStreetMap XML of things whose positions are in metres east and north of a place: an inverse of its
/// own.
class MapText {
public:
    using Tags = std::vector<std::pair<std::string, std::string>>;
    using Points = std::vector<std::pair<double, double>>;

    /// The bounds are a square around the place.
    explicit MapText(double half_size = 100.0, double latitude = 48.0, double longitude = 11.0);

    std::int64_t node(double east, double north, const Tags& tags = {});
    std::int64_t way(const Points& points, const Tags& tags = {});
    std::int64_t way_of(const std::vector<std::int64_t>& nodes, const Tags& tags = {});
    /// A closed way.
    std::int64_t ring(const Points& points, const Tags& tags = {});
    std::int64_t rectangle(double west, double south, double east, double north, const Tags& tags = {});
    /// Of ways with roles.
    std::int64_t relation(const std::vector<std::pair<std::int64_t, std::string>>& members, const Tags& tags);

    std::string xml() const;

private:
    std::string tags_xml(const Tags& tags) const;

    double half_size_;
    double latitude_;
    double longitude_;
    double degrees_north_;  ///< of a metre
    double degrees_east_;
    std::int64_t last_ = 0;
    std::string nodes_;
    std::string ways_;
    std::string relations_;
};

}  // namespace campuswalk::scene::test
