#include "engine/script/walk.h"

#include <algorithm>
#include <variant>

namespace campuswalk::engine {

bool expects_something(const Walk& walk) {
    return !walk.expectations.empty() || walk.status.kind == WalkStatus::Kind::xfail ||
           std::ranges::any_of(walk.steps, [](const Step& step) {
               return std::holds_alternative<ExpectStep>(step) || std::holds_alternative<WaitUntilStep>(step);
           });
}

}  // namespace campuswalk::engine
