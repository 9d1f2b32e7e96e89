#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <osmium/io/file.hpp>
#include <osmium/io/file_format.hpp>
#include <osmium/osm/object.hpp>

#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

ElementKind kind_of(osmium::item_type type);

/// Which elements of a file count. Of an element that is there more than once, as in history files and in
/// merged ones, it is the occurrence with the highest version; with equal versions the one with most tags,
/// then nodes or members, then the first. What is deleted doesn't count: not visible, or so marked by JOSM.
class Editions {
public:
    /// Reads what JOSM has marked.
    explicit Editions(const osmium::io::File& file);

    /// Before elements are read, from the start of the file.
    void begin();
    /// Whether the element counts; for each of the kinds read. Knows repeated elements only after choose().
    bool takes(const osmium::OSMObject& object);
    /// After all has been read once: reads the file again if it has repeated elements, and returns whether it
    /// has, so that everything must be read anew.
    bool choose(const osmium::io::File& file);
    /// Repeated elements whose occurrences differ though they have the same, highest version.
    std::vector<ElementId> ambiguous() const;
    /// Whether versions and visibility are of interest before choose().
    osmium::io::read_meta meta() const { return meta_; }

private:
    using Key = std::pair<ElementKind, std::int64_t>;
    struct Choice {
        static constexpr std::size_t kNone = SIZE_MAX;
        std::size_t number = kNone;  ///< of the occurrence that counts
        std::size_t count = 0;
        std::size_t passed = 0;  ///< since begin()
        /// Version, tags, nodes or members.
        std::tuple<std::uint32_t, std::size_t, std::size_t> rank;
        std::string content;
        bool visible = false;
        bool ambiguous = false;
    };

    bool is_visible(const osmium::OSMObject& object) const;
    void offer(Choice& choice, const osmium::OSMObject& object) const;
    void find_repeated(const osmium::io::File& file);

    std::set<std::pair<Key, std::uint32_t>> marked_;  ///< with their versions
    std::map<Key, Choice> repeated_;
    Key last_;
    bool any_passed_ = false;
    bool ascending_ = true;  ///< so far, and repeated elements are neighbours
    osmium::io::read_meta meta_ = osmium::io::read_meta::no;
};

}  // namespace campuswalk::scene::osm
