#pragma once

#include <span>
#include <string_view>

#include "config/loader/values/checked_node.h"
#include "config/loader/walk/walk_names.h"
#include "engine/script/expectation.h"

namespace campuswalk::config {

/// Reads the value of an expectation's key and reports its errors.
struct ExpectationReader {
    std::string_view name;
    engine::PlainExpectation (*read)(const CheckedNode&, const WalkNames&) = nullptr;
    bool needs_no_value = false;  ///< needs no value, as in `- stuck`, and is then read from an empty one
};

/// For the expectations that are evaluated during the walk.
std::span<const ExpectationReader> expectation_readers();

}  // namespace campuswalk::config
