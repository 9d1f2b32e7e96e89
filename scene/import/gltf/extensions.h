#pragma once

#include <string>
#include <vector>

#include "scene/import/gltf/document.h"

namespace campuswalk::scene::gltf {

/// Throws GltfError if the major version isn't 2, or if the file requires an unsupported extension; the
/// message says what to export instead.
void check_version_and_extensions(const Document& document);

/// Unsupported extensions in use that may change the shape or the image.
std::vector<std::string> unread_extensions(const Document& document);

}  // namespace campuswalk::scene::gltf
