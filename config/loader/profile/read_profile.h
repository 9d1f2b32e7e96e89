#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "config/loader/profile/profile_search.h"
#include "config/loader/profile/read_avatar.h"
#include "config/loader/profile/read_light.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/yaml_file.h"

namespace campuswalk::config {

/// Reads a profile's file. `named_at` is where the file is named: in another file, or the file itself.
template <typename Profile>
Profile open_profile(const ProfileKind& kind, const std::filesystem::path& path, const ReadRoots& roots,
                     const scene::SourceMark& named_at, scene::DiagnosticList& diagnostics) {
    Profile profile;
    if (const auto file = YamlFile::open(path, kind.suffix, roots, named_at, diagnostics)) {
        CheckedMap map(file->root(), kind.what);
        read_profile_fields(map, profile);
        map.refuse_other_keys();
    }
    return profile;
}

template <typename Profile>
Profile read_named_profile(const ProfileKind& kind, const CheckedNode& node, const ProfileFiles& files) {
    const std::optional<std::string> name = kebab_name(node);
    const auto file = name ? find_profile(kind, node, *name, files) : std::nullopt;
    if (!file) {
        return {};
    }
    files.read.push_back(*file);
    return open_profile<Profile>(kind, *file, files.roots, node.mark(), node.diagnostics());
}

/// Reads a profile as walks write it: its name, or a map that overrides some of its keys, which
/// `read_fields` reads.
template <typename Profile, typename ReadFields>
Profile read_profile(const ProfileKind& kind, const CheckedNode& node, const ProfileFiles& files,
                     const ReadFields& read_fields) {
    if (node.is_scalar()) {
        return read_named_profile<Profile>(kind, node, files);
    }
    if (!node.is_map()) {
        node.diagnose("wrong-type",
                      std::string(kind.key) + " must be a profile's name or {profile: NAME, …}");
        return {};
    }
    CheckedMap map(node, kind.key);
    const auto name = kind.has_default ? map.find("profile") : map.require("profile");
    Profile profile = name ? read_named_profile<Profile>(kind, *name, files) : Profile{};
    read_fields(map, profile);
    map.refuse_other_keys();
    return profile;
}

inline engine::LightSettings read_light(const CheckedNode& node, const ProfileFiles& files) {
    return read_profile<engine::LightSettings>(
        kLights, node, files,
        [](CheckedMap& map, engine::LightSettings& light) { read_profile_fields(map, light); });
}

}  // namespace campuswalk::config
