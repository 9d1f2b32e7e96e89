#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "collision/mesh/mesh_collider.h"
#include "engine/script/walk.h"
#include "scene/base/binary_archive.h"
#include "scene/base/diagnostic_archive.h"
#include "scene/campus/campus_description.h"

// Writes plain data into a binary archive and reads it back, whatever structs it consists of: the compiler
// finds the members, so a new step or expectation needs no line here. A struct with more members than
// `members_of` supports, or a type that isn't handled here, doesn't compile.

namespace campuswalk::packed {

using scene::ArchiveReader;
using scene::ArchiveWriter;

/// Converts to a member of any type, for counting members.
struct AnyMember {
    template <typename T>
    operator T() const;
};

template <typename T, std::size_t... I>
constexpr bool has_members(std::index_sequence<I...>) {
    return requires {
        T{(static_cast<void>(I), AnyMember{})...};
    };
}

inline constexpr std::size_t kMaxMembers = 18;

/// The number of members of a struct whose members can't be counted, because Eigen accepts anything as an
/// optional vector's value. A wrong number doesn't compile.
template <typename T>
inline constexpr std::size_t kStatedMemberCount = 0;
template <>
inline constexpr std::size_t kStatedMemberCount<scene::BoxShape> = 3;
template <>
inline constexpr std::size_t kStatedMemberCount<scene::SphereShape> = 2;
template <>
inline constexpr std::size_t kStatedMemberCount<scene::CapsuleShape> = 3;
template <>
inline constexpr std::size_t kStatedMemberCount<scene::WheelShape> = 4;
template <>
inline constexpr std::size_t kStatedMemberCount<engine::CameraSettings> = 4;
template <>
inline constexpr std::size_t kStatedMemberCount<engine::FixedView> = 4;
template <>
inline constexpr std::size_t kStatedMemberCount<engine::Views> = 5;
template <>
inline constexpr std::size_t kStatedMemberCount<engine::LightSettings> = 14;

template <typename T, std::size_t N = kMaxMembers + 1>
constexpr std::size_t member_count() {
    if constexpr (kStatedMemberCount<T> != 0) {
        return kStatedMemberCount<T>;
    } else if constexpr (has_members<T>(std::make_index_sequence<N>())) {
        return N;
    } else {
        return member_count<T, N - 1>();
    }
}

/// References to all members of an aggregate.
template <typename T>
auto members_of(T& t) {
    constexpr std::size_t kCount = member_count<std::remove_const_t<T>>();
    static_assert(kCount >= 1 && kCount <= kMaxMembers);
    // clang-format off
    if constexpr (kCount == 1) { auto& [a] = t; return std::tie(a); }
    else if constexpr (kCount == 2) { auto& [a, b] = t; return std::tie(a, b); }
    else if constexpr (kCount == 3) { auto& [a, b, c] = t; return std::tie(a, b, c); }
    else if constexpr (kCount == 4) { auto& [a, b, c, d] = t; return std::tie(a, b, c, d); }
    else if constexpr (kCount == 5) { auto& [a, b, c, d, e] = t; return std::tie(a, b, c, d, e); }
    else if constexpr (kCount == 6) { auto& [a, b, c, d, e, f] = t; return std::tie(a, b, c, d, e, f); }
    else if constexpr (kCount == 7) { auto& [a, b, c, d, e, f, g] = t; return std::tie(a, b, c, d, e, f, g); }
    else if constexpr (kCount == 8) { auto& [a, b, c, d, e, f, g, h] = t; return std::tie(a, b, c, d, e, f, g, h); }
    else if constexpr (kCount == 9) { auto& [a, b, c, d, e, f, g, h, i] = t; return std::tie(a, b, c, d, e, f, g, h, i); }
    else if constexpr (kCount == 10) { auto& [a, b, c, d, e, f, g, h, i, j] = t; return std::tie(a, b, c, d, e, f, g, h, i, j); }
    else if constexpr (kCount == 11) { auto& [a, b, c, d, e, f, g, h, i, j, k] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k); }
    else if constexpr (kCount == 12) { auto& [a, b, c, d, e, f, g, h, i, j, k, l] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l); }
    else if constexpr (kCount == 13) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m); }
    else if constexpr (kCount == 14) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n); }
    else if constexpr (kCount == 15) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o); }
    else if constexpr (kCount == 16) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p); }
    else if constexpr (kCount == 17) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q); }
    else { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r] = t; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r); }
    // clang-format on
}

template <typename T, template <typename...> class Template>
inline constexpr bool is_a = false;
template <typename... Arguments, template <typename...> class Template>
inline constexpr bool is_a<Template<Arguments...>, Template> = true;

template <typename T>
concept EigenMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T>;

/// Trees aren't packed: they are rebuilt on reading.
using MeshPtr = std::shared_ptr<const collision::MeshCollider>;

template <typename T>
void put(ArchiveWriter& out, const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        out.put(std::uint32_t{value ? 1U : 0U});  // as take_flag reads it
    } else if constexpr (std::is_enum_v<T>) {
        out.put(static_cast<std::underlying_type_t<T>>(value));
    } else if constexpr (std::is_arithmetic_v<T>) {
        out.put(value);
    } else if constexpr (std::is_same_v<T, std::string>) {
        out.put_text(value);
    } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
        out.put_text(value.string());
    } else if constexpr (std::is_same_v<T, scene::Diagnostic>) {
        scene::put(out, value);
    } else if constexpr (EigenMatrix<T>) {
        for (Eigen::Index i = 0; i < value.size(); ++i) {
            out.put(value(i));
        }
    } else if constexpr (is_a<T, std::optional>) {
        put(out, value.has_value());
        if (value) {
            put(out, *value);
        }
    } else if constexpr (is_a<T, std::vector>) {
        out.put(static_cast<std::uint64_t>(value.size()));
        for (const auto& element : value) {
            put(out, element);
        }
    } else if constexpr (is_a<T, std::variant>) {
        out.put(static_cast<std::uint32_t>(value.index()));
        std::visit([&](const auto& alternative) { put(out, alternative); }, value);
    } else if constexpr (std::is_same_v<T, MeshPtr>) {
        const collision::TriangleMesh& mesh = value->mesh();
        out.put(static_cast<std::uint64_t>(mesh.positions.size()));
        out.put_all(std::span(mesh.positions.data(), mesh.positions.size()));
        out.put(static_cast<std::uint64_t>(mesh.triangles.size()));
        out.put_all(std::span(mesh.triangles.data(), mesh.triangles.size()));
    } else if constexpr (!std::is_empty_v<T>) {
        std::apply([&](const auto&... members) { (put(out, members), ...); }, members_of(value));
    }
}

template <typename T>
void take(ArchiveReader& in, T& value);

template <typename Variant, std::size_t... I>
void take_alternative(ArchiveReader& in, Variant& value, std::index_sequence<I...>) {
    const std::uint32_t index = in.take_below(sizeof...(I), "an alternative");
    ((I == index ? take(in, value.template emplace<I>()) : void()), ...);
}

template <typename T>
void take(ArchiveReader& in, T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        value = in.take_flag();
    } else if constexpr (std::is_enum_v<T>) {
        value = static_cast<T>(in.take<std::underlying_type_t<T>>());
    } else if constexpr (std::is_arithmetic_v<T>) {
        value = in.take<T>();
    } else if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, std::filesystem::path>) {
        value = in.take_text();
    } else if constexpr (std::is_same_v<T, scene::Diagnostic>) {
        value = scene::take_diagnostic(in);
    } else if constexpr (EigenMatrix<T>) {
        for (Eigen::Index i = 0; i < value.size(); ++i) {
            value(i) = in.take<typename T::Scalar>();
        }
    } else if constexpr (is_a<T, std::optional>) {
        if (in.take_flag()) {
            take(in, value.emplace());
        }
    } else if constexpr (is_a<T, std::vector>) {
        value.resize(in.take_count(1));
        for (auto& element : value) {
            take(in, element);
        }
    } else if constexpr (is_a<T, std::variant>) {
        take_alternative(in, value, std::make_index_sequence<std::variant_size_v<T>>());
    } else if constexpr (std::is_same_v<T, MeshPtr>) {
        collision::TriangleMesh mesh;
        mesh.positions = in.take_all<Eigen::Vector3f>(in.take_count(sizeof(Eigen::Vector3f)));
        using Indices = std::array<std::uint32_t, 3>;
        mesh.triangles = in.take_all<Indices>(in.take_count(sizeof(Indices)));
        value = std::make_shared<collision::MeshCollider>(std::move(mesh));
    } else if constexpr (!std::is_empty_v<T>) {
        std::apply([&](auto&... members) { (take(in, members), ...); }, members_of(value));
    }
}

}  // namespace campuswalk::packed
