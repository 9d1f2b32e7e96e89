#pragma once

#include <cstdint>

namespace campuswalk::scene {

/// The resources that one import may use. Models are untrusted: they may make a reader run forever or exhaust
/// the memory.
struct ImportLimits {
    /// Address space, bytes. 2M triangles take 0.6 GB, 20M take 6 GB.
    std::uint64_t memory = std::uint64_t{8} << 30U;
    /// CPU time, seconds: some readers loop forever on a damaged file, however small.
    std::uint32_t cpu = 20;
    /// Additional CPU time per megabyte of the file. The slowest common format, OBJ, takes 0.03 s.
    std::uint32_t cpu_per_megabyte = 1;
    /// Wall clock time beyond the CPU time, seconds: for a slow network drive or a busy machine.
    std::uint32_t waiting = 120;
    /// Size of the response, bytes. 2M triangles with all attributes are 0.2 GB, plus textures.
    std::uint64_t response = std::uint64_t{4} << 30U;
};

}  // namespace campuswalk::scene
