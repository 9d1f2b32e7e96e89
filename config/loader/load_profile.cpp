#include "config/loader/load_profile.h"

#include <vector>

#include "config/loader/profile/read_profile.h"
#include "config/loader/read_whole.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/walk/avatar_reader.h"
#include "config/loader/walk/campus_names.h"
#include "config/loader/walk/read_camera.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

using engine::AvatarProfile;
using engine::CameraSettings;
using engine::LightSettings;
using scene::CampusDescription;

AvatarProfile load_avatar(const fs::path& avatar_file, const SearchPaths& search) {
    return read_whole_file(avatar_file, search, [&](const auto& roots, const auto& mark, auto& diagnostics) {
        return open_profile<AvatarProfile>(kAvatars, avatar_file, roots, mark, diagnostics);
    });
}

LightSettings load_light(const fs::path& light_file, const SearchPaths& search) {
    return read_whole_file(light_file, search, [&](const auto& roots, const auto& mark, auto& diagnostics) {
        return open_profile<LightSettings>(kLights, light_file, roots, mark, diagnostics);
    });
}

AvatarProfile read_avatar_text(const std::string& text, const std::string& source, const fs::path& folder,
                               const CampusDescription& campus, const SearchPaths& search) {
    const ReadRoots roots = read_roots(folder / "", search);
    const CampusNames names(&campus);
    std::vector<fs::path> read;
    const AvatarReader avatars({folder, search.avatars, roots, read}, names);
    return read_whole_text(text, source, "'avatar'",
                           [&](const CheckedNode& node) { return avatars.read(node); });
}

LightSettings read_light_text(const std::string& text, const std::string& source, const fs::path& folder,
                              const SearchPaths& search) {
    const ReadRoots roots = read_roots(folder / "", search);
    std::vector<fs::path> read;
    return read_whole_text(text, source, "'light'", [&](const CheckedNode& node) {
        return read_light(node, {folder, search.lights, roots, read});
    });
}

CameraSettings read_camera_text(const std::string& text, const std::string& source,
                                const CampusDescription& campus, const CameraSettings& camera) {
    return read_whole_text(text, source, "the camera", [&](const CheckedNode& node) {
        CameraKeys read;
        read.size = camera;
        CheckedMap map(node, "a camera");
        read_camera_fields(map, CampusNames(&campus), read);
        refuse_unused_keys(map, read.settings().view);
        map.refuse_other_keys();
        return read.settings();
    });
}

}  // namespace campuswalk::config
