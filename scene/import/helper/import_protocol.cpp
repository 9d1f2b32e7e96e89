#include "scene/import/helper/import_protocol.h"

#include <algorithm>
#include <utility>

#include "scene/base/binary_archive.h"
#include "scene/model/model_file.h"

namespace campuswalk::scene {
namespace {

constexpr FileKind kRequest = {{'c', 'w', ' ', 'i', 'm', 'p', 'o', 'r'}, 3};

bool is_error(const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::error;
}

}  // namespace

std::vector<std::byte> write_request(const ImportRequest& request) {
    ArchiveWriter out(kRequest);
    const SceneFile& file = request.file;
    out.put_text(file.mark.file);
    out.put(std::int32_t{file.mark.line});
    out.put(std::int32_t{file.mark.column});
    out.put_text(file.file);
    out.put_text(file.path.string());
    out.put(std::uint64_t{file.roots.size()});
    for (const std::filesystem::path& root : file.roots) {
        out.put_text(root.string());
    }
    out.put(std::uint32_t{file.images_beside});
    out.put(static_cast<std::uint32_t>(file.up));
    out.put(file.metres_per_unit);
    out.put(file.scale);
    for (Eigen::Index i = 0; i < 3; ++i) {
        out.put(file.position[i]);
    }
    out.put(static_cast<std::uint32_t>(request.if_empty));
    out.put(request.limits.memory);
    out.put(request.limits.cpu);
    out.put(request.limits.cpu_per_megabyte);
    out.put(request.limits.waiting);
    out.put(request.limits.response);
    out.put(static_cast<std::uint32_t>(request.sandbox));
    return concatenated(out.finish());
}

ImportRequest read_request(std::span<const std::byte> bytes) {
    constexpr std::size_t kMinTextBytes = 8;
    ArchiveReader in(bytes, kRequest);
    ImportRequest request;
    SceneFile& file = request.file;
    file.mark.file = in.take_text();
    file.mark.line = in.take<std::int32_t>();
    file.mark.column = in.take<std::int32_t>();
    file.file = in.take_text();
    file.path = in.take_text();
    file.roots.resize(in.take_count(kMinTextBytes));
    for (std::filesystem::path& root : file.roots) {
        root = in.take_text();
    }
    file.images_beside = in.take_flag();
    file.up = static_cast<UpAxis>(in.take_below(2, "up axis"));
    file.metres_per_unit = in.take<double>();
    file.scale = in.take<double>();
    for (Eigen::Index i = 0; i < 3; ++i) {
        file.position[i] = in.take<double>();
    }
    request.if_empty = static_cast<EmptyModel>(in.take_below(2, "treatment of empty models"));
    request.limits.memory = in.take<std::uint64_t>();
    request.limits.cpu = in.take<std::uint32_t>();
    request.limits.cpu_per_megabyte = in.take<std::uint32_t>();
    request.limits.waiting = in.take<std::uint32_t>();
    request.limits.response = in.take<std::uint64_t>();
    request.sandbox = static_cast<SandboxMode>(in.take_below(3, "sandbox"));
    in.finish();
    return request;
}

ImportedModel error_response(const InputError& error) {
    ImportedModel response;
    response.warnings = error.diagnostics();
    return response;
}

ImportedModel read_response(std::span<const std::byte> bytes, std::shared_ptr<const void> owner) {
    ImportedModel response = read_model_file(bytes, std::move(owner));
    if (std::ranges::any_of(response.warnings, is_error)) {
        throw InputError(std::move(response.warnings));
    }
    return response;
}

}  // namespace campuswalk::scene
