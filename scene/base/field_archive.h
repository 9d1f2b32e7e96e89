#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include "scene/base/binary_archive.h"

namespace campuswalk::scene {

/// Puts the fields of structs into an archive, as each_field(fields, struct) lists them.
class FieldWriter {
public:
    explicit FieldWriter(ArchiveWriter& out) : out_(out) {}

    template <typename... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }

private:
    void put(bool value) { out_.put(std::uint32_t{value ? 1U : 0U}); }
    template <Plain Number>
    void put(Number value) {
        out_.put(value);
    }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    void put(Enum value) { out_.put(static_cast<std::uint32_t>(value)); }
    void put(const Eigen::Vector3d& p) { (*this)(p.x(), p.y(), p.z()); }
    void put(const std::string& text) { out_.put_text(text); }
    void put(const std::vector<bool>& flags) {
        put(std::uint64_t{flags.size()});
        for (const bool flag : flags) {
            put(flag);
        }
    }
    template <typename Item>
    void put(const std::vector<Item>& list) {
        put(std::uint64_t{list.size()});
        for (const Item& item : list) {
            put(item);
        }
    }
    template <typename Value>
    void put(const std::optional<Value>& value) {
        put(value.has_value());
        if (value) {
            put(*value);
        }
    }
    template <typename Struct>
    requires std::is_class_v<Struct>
    void put(const Struct& value) { each_field(*this, value); }

    ArchiveWriter& out_;
};

/// The inverse, of untrusted bytes: throws DamagedFile. Enumerators are below end_of() of their type. `Self`
/// derives from this and may take further types.
template <typename Self>
class FieldReader {
public:
    explicit FieldReader(ArchiveReader& in) : in_(in) {}

    template <typename... Values>
    void operator()(Values&... values) {
        (static_cast<Self&>(*this).take(values), ...);
    }

protected:
    ArchiveReader& archive() { return in_; }

    void take(bool& value) { value = in_.take_flag(); }
    template <Plain Number>
    void take(Number& value) {
        value = in_.take<Number>();
    }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    void take(Enum& value) { value = static_cast<Enum>(in_.take_below(end_of(Enum()), "an enumerator")); }
    void take(Eigen::Vector3d& p) {
        constexpr double kFarthest = 2e7;  // metres
        (*this)(p.x(), p.y(), p.z());
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kFarthest) {
            throw DamagedFile("a place in it is nowhere");
        }
    }
    void take(std::string& text) { text = in_.take_text(); }
    void take(std::vector<bool>& flags) {
        const std::size_t count = in_.take_count(1);
        for (std::size_t i = 0; i < count; ++i) {
            flags.push_back(in_.take_flag());
        }
    }
    template <typename Item>
    void take(std::vector<Item>& list) {
        const std::size_t count = in_.take_count(1);
        for (std::size_t i = 0; i < count; ++i) {
            (*this)(list.emplace_back());
        }
    }
    template <typename Value>
    void take(std::optional<Value>& value) {
        if (in_.take_flag()) {
            (*this)(value.emplace());
        }
    }
    template <typename Struct>
    requires std::is_class_v<Struct>
    void take(Struct& value) {
        constexpr int kDeepest = 12;  // reasons within reasons within islands
        if (++depth_ > kDeepest) {
            throw DamagedFile("it is nested too deeply");
        }
        each_field(static_cast<Self&>(*this), value);
        --depth_;
    }

private:
    ArchiveReader& in_;
    int depth_ = 0;
};

}  // namespace campuswalk::scene
