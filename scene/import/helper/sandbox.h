#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::scene {

/// Whether an import helper gives up what reading a model doesn't need.
enum class SandboxMode : std::uint32_t {
    automatic,  ///< as far as the kernel can
    require,    ///< or not at all
    off,
};

/// What the kernel lacks for it, such as "Landlock"; empty if nothing.
std::vector<std::string> missing_sandbox_features();

/// From now on this process and its threads, and whatever takes them over, can do little but compute: they
/// can read only the files `readable` and those below such folders (Landlock), and of the system calls they
/// have those that reading files, memory and threads need (seccomp): they can't open files for writing, make
/// connections, start or signal processes, run code from memory, or change the system. They have no
/// capabilities, even of root: files that only others may read can't be read. Closes all descriptors but the
/// standard ones. There is no way back. Throws std::runtime_error if SandboxMode::require asks for more than
/// the kernel has, or if something fails that it has.
void enter_sandbox(const std::vector<std::filesystem::path>& readable, SandboxMode mode);

}  // namespace campuswalk::scene
