#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/import/helper/import_limits.h"
#include "scene/import/helper/sandbox.h"
#include "scene/import/import_model.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

struct ImportRequest {
    SceneFile file;
    EmptyModel if_empty = EmptyModel::refuse;
    ImportLimits limits;
    SandboxMode sandbox = SandboxMode::automatic;
};

std::vector<std::byte> write_request(const ImportRequest& request);
/// Throws DamagedFile.
ImportRequest read_request(std::span<const std::byte> bytes);

/// The response is a model file (model_file.h). One with errors among its warnings stands for an InputError
/// with these diagnostics.
ImportedModel error_response(const InputError& error);
/// Throws DamagedFile for invalid bytes, InputError for an error response. `owner`: as for read_model_file.
ImportedModel read_response(std::span<const std::byte> bytes, std::shared_ptr<const void> owner = nullptr);

}  // namespace campuswalk::scene
