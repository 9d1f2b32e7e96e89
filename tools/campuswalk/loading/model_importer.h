#pragma once

#include "scene/cache/load_model.h"
#include "scene/import/import_model.h"

namespace campuswalk::tools {

/// Imports models in processes of their own, which are this program under another argument: the models of
/// strangers can crash, hang or bloat those, and the user gets a message.
scene::Importer model_importer();

/// The model of a file, from the cache where that holds it. Throws scene::InputError.
scene::ImportedModel read_model(const scene::SceneFile& file, scene::EmptyModel empty);

}  // namespace campuswalk::tools
