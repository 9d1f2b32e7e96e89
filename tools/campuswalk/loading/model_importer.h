#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/cache/load_model.h"
#include "scene/import/helper/image_process.h"
#include "scene/import/import_model.h"
#include "scene/osm/helper/map_files.h"
#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

/// Imports each model in a process of its own, this program with another argument: a model from strangers can
/// only crash, hang or bloat that, and the user gets a message. So many are called `at_once`, which share the
/// memory for imports.
scene::Importer model_importer(std::size_t at_once = 1);

/// How many of so many models are imported at once: one on each processor, unless that leaves one less than a
/// gigabyte.
std::size_t imports_at_once(std::size_t models);

/// Imports a map of OpenStreetMap, likewise in a process of its own. Throws scene::InputError.
scene::osm::MapFiles read_osm_map(const scene::osm::MapRequest& request);

/// Decodes PNG files, likewise.
std::vector<scene::ForeignImage> decode_images(std::span<const std::string_view> files);

/// `--no-cache` and `--sandbox`.
void add_import_options(Command command);

/// The model of a file, from the cache where that holds it. Throws scene::InputError.
scene::LoadedModel read_model(const scene::SceneFile& file, scene::EmptyModel empty);

}  // namespace campuswalk::tools
