#include "scene/model/name_words.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "scene/base/ascii.h"

namespace campuswalk::scene {
namespace {

bool is_non_ascii(char c) {
    return (static_cast<unsigned char>(c) & 0x80U) != 0;
}

/// Lower-cases the second UTF-8 byte of a Latin-1 capital (À to Þ except ×).
char lower_latin1(char lead, char c) {
    const auto byte = static_cast<unsigned char>(c);
    const bool capital =
        static_cast<unsigned char>(lead) == 0xC3 && byte >= 0x80 && byte <= 0x9E && byte != 0x97;
    return capital ? static_cast<char>(byte + 0x20U) : c;
}

template <std::size_t N>
bool is_one_of(const std::string& word, const std::array<const char*, N>& list) {
    return std::ranges::any_of(list, [&](const char* one) { return word == one; });
}

template <std::size_t N>
bool ends_with_one_of(const std::string& word, const std::array<const char*, N>& list) {
    return std::ranges::any_of(list, [&](const char* one) { return word.ends_with(one); });
}

template <std::size_t N>
bool has_one_of(std::string_view name, const std::array<const char*, N>& list) {
    return std::ranges::any_of(list,
                               [&](const char* one) { return name.find(one) != std::string_view::npos; });
}

constexpr std::array kDoors = {"doors", "porte", "portes", "puerta", "puertas",
                               "porta", "drzwi", "дверь",  "двери",  "dörrar"};
// In German, Dutch, Swedish and English, compounds end in the word: Haustür, frontdoor.
constexpr std::array kDoorSuffixes = {"tür",    "türe", "türen", "tuer", "tuere",
                                      "tueren", "deur", "dörr",  "door"};
constexpr std::array kDoorExceptions = {"indoor", "outdoor", "trapdoor"};
constexpr std::array kDoorCharacters = {"门", "門", "ドア", "扉"};
constexpr std::array kDoorParts = {
    "frame",  "frames", "handle", "handles", "knob",   "bell", "mat",  "way",  "sign",  "step",
    "steps",  "jamb",   "lintel", "hinge",   "hinges", "trim", "hole", "gap",  "arch",  "opening",
    "rahmen", "griff",  "plate",  "sill",    "lock",   "key",  "stop", "case", "casing"};

constexpr std::array kStairs = {"stair", "stairs",   "staircase", "stairway", "stairwell",
                                "steps", "escalier", "escaliers", "escalera", "escaleras",
                                "scala", "trappa",   "schody",    "лестница"};
constexpr std::array kStairsSuffixes = {"treppe", "treppen", "stufen"};
constexpr std::array kStairsCharacters = {"楼梯", "階段", "계단"};

constexpr std::array kSurroundings = {
    "tree",       "trees",  "hedge",   "hedges",   "bush",      "bushes",  "plant",    "plants",   "grass",
    "lawn",       "forest", "path",    "paths",    "road",      "roads",   "street",   "streets",  "kerb",
    "curb",       "way",    "track",   "sidewalk", "pavement",  "footway", "terrain",  "ground",   "hill",
    "fence",      "fences", "railing", "railings", "landscape", "water",   "lake",     "river",    "pond",
    "sea",        "sky",    "skybox",  "platform", "stage",     "stairs",  "steps",    "ramp",     "lamp",
    "lamps",      "light",  "lights",  "fountain", "bench",     "benches", "car",      "cars",     "truck",
    "trucks",     "bus",    "van",     "bike",     "bikes",     "bicycle", "bicycles", "vehicle",  "vehicles",
    "vegetation", "pole",   "flag",    "flags",    "flagpole",  "banner",  "marking",  "markings", "decal",
    "decals",     "sign",   "signs",   "chair",    "chairs",    "table",   "tables",   "desk",     "desks",
    "furniture",  "bed",    "sofa",    "shelf",    "shelves",   "cabinet", "parking",  "baum",     "bäume",
    "hecke",      "weg",    "straße",  "strasse",  "gelände",   "wiese",   "zaun",     "laterne",  "bank",
    "auto",       "arbre",  "route",   "chemin",   "clôture",   "arbol",   "árbol",    "calle",    "valla",
    "дерево",     "дорога", "забор",   "земля"};
constexpr std::array kSurroundingsCharacters = {"树", "樹", "道路", "地面", "草地", "나무", "도로", "지면"};

constexpr std::array kWaters = {"water", "lake",  "river",    "pond",  "sea",   "ocean",   "wasser", "see",
                                "teich", "fluss", "meer",     "eau",   "lac",   "rivière", "étang",  "agua",
                                "lago",  "río",   "estanque", "acqua", "fiume", "вода",    "озеро",  "река"};
constexpr std::array kWaterCharacters = {"水面", "湖", "河", "池塘", "海面", "水体", "호수", "강물"};

constexpr std::array kSkies = {"sky",      "skybox", "skydome", "skysphere", "cloud", "clouds",
                               "backdrop", "himmel", "wolken",  "ciel",      "cielo", "небо"};
constexpr std::array kSkyCharacters = {"天空", "天球", "하늘"};

constexpr std::array kOperands = {"cutter", "cutters", "boolean", "booleans",
                                  "bool",   "hole",    "holes",   "cutout"};

constexpr std::array kBuildings = {
    "building", "buildings", "house",    "houses",   "hall",    "library",   "school", "faculty", "institute",
    "lab",      "labs",      "gym",      "theatre",  "theater", "museum",    "church", "chapel",  "tower",
    "pavilion", "centre",    "center",   "station",  "hotel",   "dormitory", "garage", "office",  "offices",
    "cafe",     "canteen",   "shop",     "hospital", "haus",    "gebäude",   "halle",  "turm",    "mensa",
    "bâtiment", "maison",    "edificio", "casa",     "здание",  "дом"};
constexpr std::array kBuildingsSuffixes = {"house", "haus", "gebäude", "gebaeude", "halle", "bibliothek"};

constexpr std::array kBuildingParts = {
    "wall",    "walls",    "floor",   "floors", "ceiling", "ceilings", "roof",    "roofs",   "column",
    "columns", "pillar",   "pillars", "window", "windows", "door",     "doors",   "room",    "rooms",
    "storey",  "story",    "level",   "facade", "façade",  "balcony",  "beam",    "beams",   "slab",
    "slabs",   "glass",    "frame",   "frames", "stair",   "corridor", "lobby",   "shaft",   "lift",
    "wand",    "wände",    "mauer",   "boden",  "decke",   "dach",     "fenster", "raum",    "zimmer",
    "etage",   "geschoss", "mur",     "murs",   "sol",     "plafond",  "toit",    "fenêtre", "salle",
    "muro",    "muros",    "suelo",   "techo",  "ventana", "стена",    "крыша",   "окно",    "комната"};

constexpr std::array kDefaultNames = {
    "cube",  "box",       "cylinder", "plane",       "sphere",  "mesh",  "object",    "obj",      "group",
    "node",  "component", "polygon",  "polysurface", "surface", "solid", "shape",     "line",     "extrude",
    "empty", "collider",  "geometry", "poly",        "model",   "scene", "root",      "instance", "element",
    "body",  "part",      "entity",   "default",     "sketch",  "up",    "sketchfab", "skp"};

/// Whether the name contains a GUID: 8, 4, 4, 4 and 12 hexadecimal digits.
bool contains_guid(std::string_view name) {
    constexpr std::string_view kPattern = "xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx";
    for (std::size_t start = 0; start + kPattern.size() <= name.size(); ++start) {
        bool matches = true;
        for (std::size_t i = 0; matches && i < kPattern.size(); ++i) {
            const char c = name[start + i];
            matches = kPattern[i] == 'x' ? is_hex_digit(c) : (c == '-' || c == '_');
        }
        if (matches) {
            return true;
        }
    }
    return false;
}

bool is_ifc_guid(std::string_view name) {
    const auto digits = std::ranges::count_if(name, is_digit);
    const auto upper = std::ranges::count_if(name, is_upper);
    const auto lower = std::ranges::count_if(name, is_lower);
    const bool alphabet = std::ranges::all_of(
        name, [](char c) { return is_digit(c) || is_upper(c) || is_lower(c) || c == '_' || c == '$'; });
    return name.size() == 22 && name[0] >= '0' && name[0] <= '3' && alphabet && digits >= 2 && upper >= 2 &&
           lower >= 2;
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words;
    char before = ' ';
    for (const char c : name) {
        const bool letter = is_lower(c) || is_upper(c) || is_non_ascii(c);
        const bool after_letter = is_lower(before) || is_upper(before) || is_non_ascii(before);
        if (letter && (!after_letter || (is_upper(c) && is_lower(before)))) {
            words.emplace_back();
        }
        if (letter) {
            words.back() += is_upper(c) ? static_cast<char>(c - 'A' + 'a') : lower_latin1(before, c);
        }
        before = c;
    }
    return words;
}

bool is_door_name(std::string_view name) {
    const std::vector<std::string> words = words_of(name);
    const bool part =
        std::ranges::any_of(words, [](const std::string& w) { return is_one_of(w, kDoorParts); });
    const bool door = std::ranges::any_of(words, [](const std::string& w) {
        return is_one_of(w, kDoors) || (ends_with_one_of(w, kDoorSuffixes) && !is_one_of(w, kDoorExceptions));
    });
    return !part && (door || has_one_of(name, kDoorCharacters));
}

bool is_stairs_name(std::string_view name) {
    const std::vector<std::string> words = words_of(name);
    return has_one_of(name, kStairsCharacters) || std::ranges::any_of(words, [](const std::string& w) {
               return is_one_of(w, kStairs) || ends_with_one_of(w, kStairsSuffixes);
           });
}

namespace {

/// Whether a word of the name, or characters in it, are on the lists, and none means a building.
template <std::size_t Words, std::size_t Characters>
bool means_none_built(std::string_view name, const std::array<const char*, Words>& words,
                      const std::array<const char*, Characters>& characters) {
    const std::vector<std::string> own = words_of(name);
    const bool building = std::ranges::any_of(own, [](const std::string& w) {
        return is_one_of(w, kBuildings) || ends_with_one_of(w, kBuildingsSuffixes);
    });
    const bool meant = std::ranges::any_of(own, [&](const std::string& w) { return is_one_of(w, words); });
    return !building && (meant || has_one_of(name, characters));
}

}  // namespace

bool is_surroundings_name(std::string_view name) {
    return means_none_built(name, kSurroundings, kSurroundingsCharacters);
}

bool is_water_name(std::string_view name) {
    return means_none_built(name, kWaters, kWaterCharacters);
}

bool is_sky_name(std::string_view name) {
    return means_none_built(name, kSkies, kSkyCharacters);
}

bool is_operand_name(std::string_view name) {
    return std::ranges::any_of(words_of(name),
                               [](const std::string& word) { return is_one_of(word, kOperands); });
}

bool is_building_part_name(std::string_view name) {
    const std::vector<std::string> words = words_of(name);
    return is_door_name(name) ||
           std::ranges::any_of(words, [](const std::string& w) { return is_one_of(w, kBuildingParts); });
}

bool is_generated_name(std::string_view name) {
    return name.empty() || name.starts_with("nodes[") || name.starts_with("$ColladaAutoName$") ||
           name.starts_with("<") || name == "defaultobject";
}

bool is_default_name(std::string_view name) {
    const std::vector<std::string> words = words_of(name);
    return std::ranges::all_of(
        words, [](const std::string& w) { return w.size() == 1 || is_one_of(w, kDefaultNames); });
}

bool is_identifier(std::string_view name) {
    const bool number = !name.empty() && std::ranges::all_of(name, is_digit);
    const bool long_number = name.size() >= 16 && std::ranges::all_of(name, is_hex_digit);
    return number || long_number || contains_guid(name) || is_ifc_guid(name);
}

}  // namespace campuswalk::scene
