#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace campuswalk::tools {

inline constexpr std::string_view kCampusSchema = "campus.schema.json";
inline constexpr std::string_view kWalkSchema = "walk.schema.json";

/// The comment by which editors find the schema of a YAML file, if the file's project has that schema: in
/// `schema/` beside the file or above it, where init puts it. Else empty.
std::string schema_line(const std::filesystem::path& file, std::string_view schema);

}  // namespace campuswalk::tools
