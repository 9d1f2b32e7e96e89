#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "engine/events/reason.h"

namespace campuswalk::engine {

template <typename Struct, typename Plain>
concept MaybeConst = std::same_as<std::remove_const_t<Struct>, Plain>;

/// The fields of a reason, as result_fields.h lists those of results.
template <typename Fields>
void list_fields(Fields& fields, MaybeConst<Reason> auto& reason) {
    fields("kind", reason.kind);
    const bool is_angle = reason.kind == ReasonKind::slope;
    fields.if_any("object", reason.object);
    fields.if_any("node", reason.node);
    fields.if_any("is_node", reason.is_node);
    fields.if_any("name", reason.name);
    fields.if_any("at", reason.at);
    fields.if_any(is_angle ? "measured_deg" : "measured", reason.measured);
    fields.if_any(is_angle ? "allowed_deg" : "allowed", reason.allowed);
    fields.if_any("detour", reason.detour);
    fields.if_any("from", reason.from);
    fields.if_any("room", reason.room);
    fields.if_any("look_at", reason.look_at);
    fields.if_any("more", reason.more);
    fields.if_any("parts", reason.parts);
}

/// In an archive they have no names.
template <typename Fields>
struct UnnamedFields {
    Fields& fields;

    void operator()(const char* /*name*/, auto& value) { fields(value); }
    void if_any(const char* /*name*/, auto& value) { fields(value); }
};

void each_field(auto& fields, MaybeConst<Reason> auto& reason) {
    UnnamedFields<std::remove_reference_t<decltype(fields)>> unnamed{fields};
    list_fields(unnamed, reason);
}

inline std::uint32_t end_of(ReasonKind /*kind*/) {
    return static_cast<std::uint32_t>(reason_kinds().size());
}

}  // namespace campuswalk::engine
