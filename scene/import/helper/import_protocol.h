#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/model/scene_file.h"
#include "scene/import/import_model.h"

namespace campuswalk::scene {

/// What one import may use up before it is ended. A model is data from strangers, and its reader may be led
/// to fill the memory or to run for ever.
struct ImportLimits {
    /// Address space, bytes. 2M triangles take 0.6 GB and 20M of them 6 GB.
    std::uint64_t memory = std::uint64_t{8} << 30U;
    /// Seconds of CPU: some readers never come to an end of a damaged file, however small.
    std::uint32_t cpu = 20;
    /// That many more for each megabyte of the file. The slowest format in use, OBJ, takes 0.03.
    std::uint32_t cpu_per_megabyte = 1;
    /// Seconds on the clock beyond those of CPU: for a folder on a slow network and a machine with other
    /// work.
    std::uint32_t waiting = 120;
    /// Bytes of the answer. 2M triangles with all they can have are 0.2 GB, textures come on top.
    std::uint64_t answer = std::uint64_t{4} << 30U;
};

/// What is asked of the helper.
struct ImportRequest {
    SceneFile file;
    EmptyModel if_empty = EmptyModel::refuse;
    ImportLimits limits;
};

std::vector<std::byte> write_request(const ImportRequest& request);
/// Throws DamagedFile.
ImportRequest read_request(std::span<const std::byte> bytes);

/// The answer is a model file (model_file.h). One with errors among its warnings stands for an InputError
/// with these.
ImportedModel refusal_of(const InputError& error);
/// Throws DamagedFile for bytes that are no answer, InputError for a refusal. `owner`: as for
/// read_model_file.
ImportedModel read_answer(std::span<const std::byte> bytes, std::shared_ptr<const void> owner = nullptr);

}  // namespace campuswalk::scene
