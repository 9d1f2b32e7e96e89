#pragma once

#include <string>
#include <vector>

#include "scene/import/gltf/document.h"

namespace campuswalk::scene::gltf {

/// Throws Fault when the file is of another major version than 2, or can't be shown without an extension that
/// isn't read; the message says what to export instead.
void check_version_and_extensions(const Document& document);

/// Extensions that the file uses, that aren't read and that might show.
std::vector<std::string> unread_extensions(const Document& document);

}  // namespace campuswalk::scene::gltf
