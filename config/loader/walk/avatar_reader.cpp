#include "config/loader/walk/avatar_reader.h"

#include <optional>
#include <string>

#include "config/loader/profile/profile_search.h"
#include "config/loader/profile/read_avatar.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/yaml_file.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

using engine::AvatarProfile;

AvatarProfile open_avatar(const fs::path& path, const ReadRoots& roots, const scene::SourceMark& named_at,
                          scene::DiagnosticList& diagnostics) {
    AvatarProfile profile;
    if (const auto file = YamlFile::open(path, ".avatar.yaml", roots, named_at, diagnostics)) {
        CheckedMap map(file->root(), "an avatar");
        read_avatar_fields(map, profile);
        map.refuse_other_keys();
    }
    return profile;
}

AvatarProfile AvatarReader::read(const CheckedNode& node) const {
    if (node.is_scalar()) {
        return named(node);
    }
    if (!node.is_map()) {
        node.diagnose("wrong-type", "'avatar' must be a profile's name or {profile: NAME, …}");
        return {};
    }
    CheckedMap map(node, "'avatar'");
    const auto name = map.require("profile");
    AvatarProfile profile = name ? named(*name) : AvatarProfile{};
    for (const CheckedNode& layer : read_avatar_fields(map, profile)) {
        names_.check_layer(layer, name_in(layer).value_or(""));
    }
    map.refuse_other_keys();
    return profile;
}

AvatarProfile AvatarReader::named(const CheckedNode& node) const {
    const std::optional<std::string> name = kebab_name(node);
    const auto file =
        name ? find_profile(kAvatars, node, *name, profile_folders(kAvatars, folder_, more_)) : std::nullopt;
    if (!file) {
        return {};
    }
    profiles_.push_back(*file);
    return open_avatar(*file, roots_, node.mark(), node.diagnostics());
}

}  // namespace campuswalk::config
