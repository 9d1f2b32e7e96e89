#include "scene/import/gltf/gltf_source.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "scene/import/gltf/document.h"
#include "scene/import/gltf/node_graph.h"
#include "scene/import/source/file_frame.h"
#include "scene/import/source/tangent_frame.h"

namespace campuswalk::scene::gltf {

namespace {

// Includes image formats that can't be decoded: those are reported for the materials that use them.
constexpr std::array<std::string_view, 12> kSupported = {
    "CESIUM_RTC",          "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression", "EXT_texture_avif",
    "EXT_texture_webp",    "KHR_draco_mesh_compression", "KHR_mesh_quantization",   "KHR_meshopt_compression",
    "KHR_node_visibility", "KHR_texture_basisu",         "KHR_texture_transform",   "MSFT_texture_dds"};

// Prefixes of extensions that change neither a walk nor its images: sheen, lights, animation, metadata.
constexpr std::array<std::string_view, 9> kIgnorable = {"KHR_materials_", "KHR_lights_", "EXT_lights_",
                                                        "KHR_animation_", "KHR_xmp",     "KHR_audio",
                                                        "EXT_materials_", "MSFT_audio",  "FB_ngon_encoding"};

bool is_supported(const std::string& name) {
    return std::ranges::find(kSupported, name) != kSupported.end() ||
           std::ranges::any_of(kIgnorable, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

/// Unsupported extensions in use that may change the shape or the image.
std::vector<std::string> unread_extensions(const Document& document) {
    std::vector<std::string> unsupported;
    for (const std::string& name : document.root().strings("extensionsUsed")) {
        if (!is_supported(name)) {
            unsupported.push_back(name);
        }
    }
    return unsupported;
}

/// Throws GltfError if the major version isn't 2, or if the file requires an unsupported extension; the
/// message says what to export instead.
void check_version_and_extensions(const Document& document) {
    const auto asset = document.root().object("asset");
    if (!asset) {
        throw GltfError("it has no 'asset', so it is not glTF");
    }
    const std::string version = asset->string("version");
    if (!version.starts_with("2.")) {
        throw GltfError("it is glTF version '" + version +
                        "'; only version 2 is supported: convert it to glTF 2.0");
    }
    for (const std::string& name : document.root().strings("extensionsRequired")) {
        if (!is_supported(name)) {
            throw GltfError("it requires the extension " + name +
                            ", which is not supported; export without it");
        }
    }
    unread_extensions(document);  // throws unless they are names
}

/// What CESIUM_RTC says: coordinates are relative to a distant centre ("rtc").
struct CenterFrame {
    Eigen::Matrix4d X_file_rtc = Eigen::Matrix4d::Identity();
    std::optional<GeographicPlace> place;  ///< of the centre, without its `at`
};

/// A centre in ECEF coordinates, as map servers use, becomes the origin, with the local up and north. Any
/// other is taken for map coordinates and translates the file. The extension's axes are Z-up. Identity
/// without it.
CenterFrame center_frame(const Document& document) {
    CenterFrame frame;
    const auto extensions = document.root().object("extensions");
    const auto relative = extensions ? extensions->object("CESIUM_RTC") : std::nullopt;
    if (!relative) {
        return frame;
    }
    const auto numbers = relative->doubles("center", 3);
    if (!numbers) {
        relative->fail("lacks 'center'");
    }
    Eigen::Matrix3d R_center_rtc;  // Y-up to Z-up
    R_center_rtc << 1, 0, 0,       //
        0, 0, -1,                  //
        0, 1, 0;
    const Eigen::Vector3d center((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    if (const auto tangent = tangent_frame(center)) {
        frame.place = tangent->place;
        frame.X_file_rtc.topLeftCorner<3, 3>() = tangent->R_local_ecef * R_center_rtc;
    } else {
        frame.X_file_rtc.topRightCorner<3, 1>() = R_center_rtc.transpose() * center;
    }
    return frame;
}

}  // namespace

struct GltfSource::Parts {
    explicit Parts(const SceneFile& file)
        : folder(file),
          container(read_container(file.path)),
          document(container.json),
          buffers(document, container.binary, folder) {}

    SceneFolder folder;
    Container container;
    Document document;
    Buffers buffers;
    std::vector<GltfMaterial> materials;
    std::unique_ptr<Primitives> primitives;
    GraphNotes notes;
    std::optional<GeographicPlace> geographic;  ///< of a CESIUM_RTC centre
};

/// Runs `call` and turns GltfError into InputError.
template <typename Call>
auto GltfSource::reading(const Call& call) const {
    try {
        return call();
    } catch (const GltfError& error) {
        throw InputError(file_.mark, "bad-model",
                         "'" + file_.file + "' can't be read as a model: " + error.what());
    }
}

GltfSource::GltfSource(const SceneFile& file) : file_(file) {
    reading([&] {
        parts_ = std::make_unique<Parts>(file);
        check_version_and_extensions(parts_->document);
        parts_->materials = read_materials(parts_->document);
        for (const GltfMaterial& material : parts_->materials) {
            materials_.push_back(material.source);
        }
        parts_->primitives =
            std::make_unique<Primitives>(parts_->document, parts_->buffers, parts_->materials);
    });
}

GltfSource::~GltfSource() = default;

NodeTree GltfSource::nodes() {
    return reading([&] {
        Accessors accessors(parts_->document, parts_->buffers);
        const CenterFrame frame = center_frame(parts_->document);
        parts_->geographic = frame.place;
        return read_node_graph(parts_->document, *parts_->primitives, accessors,
                               world_from_file(file_) * frame.X_file_rtc, parts_->notes);
    });
}

std::optional<GeographicPlace> GltfSource::geographic() const {
    std::optional<GeographicPlace> place = parts_->geographic;
    if (place) {
        place->at = file_.position;
    }
    return place;
}

RawMesh GltfSource::mesh(std::size_t number) {
    return reading([&] { return parts_->primitives->read(number); });
}

std::optional<DecodedImage> GltfSource::embedded_image(std::size_t image, std::string& reason) {
    const JsonObject item = parts_->document.item("images", image);
    if (const auto data = Buffers::data_of_uri(item.string("uri"))) {
        return decode_image(*data, reason);
    }
    const auto bytes = parts_->buffers.view(item.required_uint("bufferView"));
    if (!bytes) {
        reason = "has no data in the file; re-export it";
        return std::nullopt;
    }
    return decode_image(*bytes, reason);
}

std::optional<DecodedImage> GltfSource::load_image(const TextureReference& reference, std::string& reason) {
    if (!reference.uri.starts_with('*')) {
        return read_image(parts_->folder, reference.uri, reason);
    }
    std::size_t image = 0;
    std::from_chars(reference.uri.data() + 1, reference.uri.data() + reference.uri.size(), image);
    return reading([&] { return embedded_image(image, reason); });
}

std::vector<FileRequest> GltfSource::requests() const {
    return parts_->folder.requests();
}

void GltfSource::add_warnings(DiagnosticList& warnings) {
    const auto warn = [&](DiagnosticCode code, const std::string& message) {
        warnings.warning(file_.mark, code, file_.file + ": " + message);
    };
    const GraphNotes& notes = parts_->notes;
    if (notes.ignored_scenes > 0) {
        warn("unsupported-feature",
             std::to_string(notes.ignored_scenes + 1) +
                 " scenes: only the default scene is imported, or else the first; export one file per scene");
    }
    if (notes.unplaced_meshes > 0 && notes.ignored_scenes == 0) {
        warn("unplaced-mesh",
             "meshes not placed by the scene, ignored: " + std::to_string(notes.unplaced_meshes));
    }
    if (notes.meshes_at_origin > 0) {
        warn("unplaced-mesh",
             "meshes without a node, placed at the origin: " + std::to_string(notes.meshes_at_origin));
    }
    if (notes.hidden > 0) {
        warn("hidden-nodes", "meshes that KHR_node_visibility hides, neither drawn nor solid: " +
                                 std::to_string(notes.hidden));
    }
    if (parts_->primitives->without_data() > 0) {
        warn("missing-data", "mesh arrays without data in the file, read as zeros: " +
                                 std::to_string(parts_->primitives->without_data()));
    }
    for (const GltfMaterial& material : parts_->materials) {
        for (const std::string& key : material.ignored_images) {
            warn("unsupported-feature",
                 "material '" + material.source.material.name + "': " + key +
                     " uses a different set of texture coordinates than its first texture; "
                     "drawn without it");
        }
    }
    for (const std::string& name : unread_extensions(parts_->document)) {
        warn("unsupported-feature", name + ": ignored, so what it adds is missing; export without it");
    }
}

}  // namespace campuswalk::scene::gltf
