#include "scene/import/gltf/accessors.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>

#include "scene/import/source/sanitize_mesh.h"

namespace campuswalk::scene::gltf {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float) && sizeof(Eigen::Vector2f) == 2 * sizeof(float));

namespace {

enum class Component : std::uint16_t {
    signed_byte = 5120,
    unsigned_byte = 5121,
    signed_short = 5122,
    unsigned_short = 5123,
    unsigned_int = 5125,
    single = 5126,
};

// Keeps the sizes below from overflowing.
constexpr std::size_t kMaxElements = std::size_t{1} << 32U;
// A buffer view's elements are bounded by its bytes.
constexpr std::size_t kMaxZeros = 10'000'000;

std::size_t bytes_of(Component component) {
    switch (component) {
        case Component::signed_byte:
        case Component::unsigned_byte:
            return 1;
        case Component::signed_short:
        case Component::unsigned_short:
            return 2;
        default:
            return 4;
    }
}

template <typename Stored, typename T>
T converted(const std::uint8_t* at, bool normalized) {
    Stored stored{};
    std::memcpy(&stored, at, sizeof stored);
    // NOLINTNEXTLINE(bugprone-signed-char-misuse): a negative index becomes huge and is rejected
    const auto value = static_cast<T>(stored);
    if constexpr (std::is_integral_v<Stored> && std::is_floating_point_v<T>) {
        if (normalized) {
            return std::max(value / static_cast<T>(std::numeric_limits<Stored>::max()), T{-1});
        }
    }
    return value;
}

template <typename T>
T component_at(const std::uint8_t* at, Component component, bool normalized) {
    switch (component) {
        case Component::signed_byte:
            return converted<std::int8_t, T>(at, normalized);
        case Component::unsigned_byte:
            return converted<std::uint8_t, T>(at, normalized);
        case Component::signed_short:
            return converted<std::int16_t, T>(at, normalized);
        case Component::unsigned_short:
            return converted<std::uint16_t, T>(at, normalized);
        case Component::unsigned_int:
            return converted<std::uint32_t, T>(at, normalized);
        case Component::single:
            break;
    }
    if constexpr (std::is_integral_v<T>) {
        return T{};  // rejected before: see indices()
    } else {
        return converted<float, T>(at, normalized);
    }
}

struct StridedView {
    const std::uint8_t* first = nullptr;
    std::size_t stride = 0;
};

/// The elements from `item`'s byteOffset on; throws unless `count` elements of `size` bytes fit.
StridedView strided_view(const JsonObject& item, Bytes view, std::size_t stride, std::size_t count,
                         std::size_t size) {
    const std::size_t offset = item.uint("byteOffset").value_or(0);
    const std::size_t step = stride == 0 ? size : stride;
    if (count > 0) {
        const std::size_t room = offset > view.size() ? 0 : view.size() - offset;
        if (size > room || (count - 1) > (room - size) / step) {
            item.fail("extends past the end of its buffer view");
        }
    }
    return {view.data() + offset, step};
}

}  // namespace

struct Accessors::Layout {
    std::size_t count = 0;
    std::size_t components = 0;
    Component component = Component::single;
    bool normalized = false;

    std::size_t element_bytes() const { return components * bytes_of(component); }
};

Accessors::Layout Accessors::layout_of(const JsonObject& item) const {
    struct Shape {
        std::string_view name;
        std::size_t components;
    };
    constexpr std::array<Shape, 5> kShapes = {
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};
    Layout layout;
    layout.count = item.required_uint("count");
    const std::size_t component = item.required_uint("componentType");
    const std::string type = item.string("type");
    const auto* shape = std::ranges::find(kShapes, type, &Shape::name);
    const bool known = (component >= 5120 && component <= 5123) || component == 5125 || component == 5126;
    if (shape == kShapes.end() || !known) {
        item.fail("has a type or componentType that is not valid for a mesh");
    }
    const std::optional<std::size_t> view = item.uint("bufferView");
    const bool has_data = view && buffers_.view(*view);
    if (layout.count > (has_data ? kMaxElements : kMaxZeros)) {
        item.fail("has an implausible count of " + std::to_string(layout.count));
    }
    layout.components = shape->components;
    layout.component = static_cast<Component>(component);
    layout.normalized = item.boolean("normalized");
    return layout;
}

template <typename T>
void Accessors::read(const JsonObject& item, const Layout& layout, std::span<T> out) {
    const auto view_index = item.uint("bufferView");
    const auto view = view_index ? buffers_.view(*view_index) : std::nullopt;
    const auto sparse = item.object("sparse");
    if (view) {
        const std::size_t stride = document_.item("bufferViews", *view_index).uint("byteStride").value_or(0);
        const std::size_t size = bytes_of(layout.component);
        const StridedView run = strided_view(item, *view, stride, layout.count, layout.element_bytes());
        const Component plain = std::is_same_v<T, float> ? Component::single : Component::unsigned_int;
        const bool contiguous = layout.component == plain && run.stride == layout.element_bytes();
        if (contiguous && !out.empty()) {
            std::memcpy(out.data(), run.first, out.size_bytes());
        }
        for (std::size_t i = 0; !contiguous && i < layout.count; ++i) {
            const std::uint8_t* element = run.first + i * run.stride;
            for (std::size_t k = 0; k < layout.components; ++k) {
                out[i * layout.components + k] =
                    component_at<T>(element + k * size, layout.component, layout.normalized);
            }
        }
    } else if (!sparse) {
        ++without_data_;
    }
    if (sparse) {
        read_sparse(*sparse, layout, out);
    }
}

template <typename T>
void Accessors::read_sparse(const JsonObject& sparse, const Layout& layout, std::span<T> out) {
    const std::size_t count = sparse.required_uint("count");
    const auto indices = sparse.object("indices");
    const auto values = sparse.object("values");
    if (!indices || !values) {
        sparse.fail("lacks 'indices' or 'values'");
    }
    const auto index_type = static_cast<Component>(indices->required_uint("componentType"));
    if (index_type != Component::unsigned_byte && index_type != Component::unsigned_short &&
        index_type != Component::unsigned_int) {
        indices->fail("has a componentType that is not valid for indices");
    }
    const auto index_bytes = buffers_.view(indices->required_uint("bufferView"));
    const auto value_bytes = buffers_.view(values->required_uint("bufferView"));
    if (!index_bytes || !value_bytes) {
        return;  // zeros replace zeros
    }
    const std::size_t size = bytes_of(layout.component);
    const StridedView index_run = strided_view(*indices, *index_bytes, 0, count, bytes_of(index_type));
    const StridedView value_run = strided_view(*values, *value_bytes, 0, count, layout.element_bytes());
    for (std::size_t i = 0; i < count; ++i) {
        const auto element =
            component_at<std::uint32_t>(index_run.first + i * index_run.stride, index_type, false);
        if (element >= layout.count) {
            indices->fail("refers to an element that its accessor does not have");
        }
        for (std::size_t k = 0; k < layout.components; ++k) {
            out[element * layout.components + k] = component_at<T>(
                value_run.first + i * value_run.stride + k * size, layout.component, layout.normalized);
        }
    }
}

std::size_t Accessors::count(std::size_t index) const {
    return layout_of(document_.item("accessors", index)).count;
}

std::vector<float> Accessors::floats(std::size_t index, int components) {
    const JsonObject item = document_.item("accessors", index);
    const Layout layout = layout_of(item);
    if (layout.components != static_cast<std::size_t>(components)) {
        item.fail("has the type " + item.string("type") + ", which is not valid here");
    }
    std::vector<float> result(layout.count * layout.components);
    read<float>(item, layout, result);
    return result;
}

template <int kComponents>
std::vector<Eigen::Matrix<float, kComponents, 1>> Accessors::vectors(std::size_t index) {
    using Vector = Eigen::Matrix<float, kComponents, 1>;
    const JsonObject item = document_.item("accessors", index);
    const Layout layout = layout_of(item);
    if (layout.components != kComponents) {
        item.fail("has the type " + item.string("type") + " instead of VEC" + std::to_string(kComponents));
    }
    std::vector<Vector> result(layout.count, Vector::Zero());
    read<float>(item, layout,
                {result.empty() ? nullptr : result.data()->data(), result.size() * kComponents});
    return result;
}

/// Sets the last row of each to 0, 0, 0, 1, whatever the file says.
std::vector<Eigen::Matrix4d> Accessors::matrices(std::size_t index) {
    const std::vector<float> values = floats(index, 16);
    std::vector<Eigen::Matrix4d> result;
    result.reserve(values.size() / 16);
    for (std::size_t at = 0; at < values.size(); at += 16) {
        result.push_back(Eigen::Map<const Eigen::Matrix4f>(&values[at]).cast<double>());
        result.back().bottomRows<1>() << 0, 0, 0, 1;
    }
    return result;
}

std::vector<Eigen::Vector4f> Accessors::vectors4(std::size_t index) {
    return vectors<4>(index);
}

std::vector<Eigen::Vector3f> Accessors::vectors3(std::size_t index) {
    return vectors<3>(index);
}

std::vector<Eigen::Vector2f> Accessors::vectors2(std::size_t index) {
    return vectors<2>(index);
}

std::vector<std::array<std::uint8_t, 4>> Accessors::colors(std::size_t index) {
    const JsonObject item = document_.item("accessors", index);
    const Layout layout = layout_of(item);
    if (layout.components < 3) {
        item.fail("has the type " + item.string("type") + " instead of VEC3 or VEC4");
    }
    std::vector<float> values(layout.count * layout.components);
    read<float>(item, layout, values);
    std::vector<std::array<std::uint8_t, 4>> result;
    result.reserve(layout.count);
    for (std::size_t i = 0; i < values.size(); i += layout.components) {
        const float alpha = layout.components == 4 ? values[i + 3] : 1.0F;
        result.push_back(to_rgba8(values[i], values[i + 1], values[i + 2], alpha));
    }
    return result;
}

std::vector<std::uint32_t> Accessors::indices(std::size_t index) {
    const JsonObject item = document_.item("accessors", index);
    const Layout layout = layout_of(item);
    if (layout.components != 1 || layout.component == Component::single) {
        item.fail("has a type that is not valid for indices");
    }
    std::vector<std::uint32_t> result(layout.count);
    read<std::uint32_t>(item, layout, result);
    return result;
}

}  // namespace campuswalk::scene::gltf
