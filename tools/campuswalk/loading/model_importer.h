#pragma once

#include "scene/import/import_model.h"

namespace campuswalk::tools {

/// Imports models in processes of their own, which are this program under another argument: the models of
/// strangers can crash, hang or bloat those, and the user gets a message.
scene::Importer model_importer();

}  // namespace campuswalk::tools
