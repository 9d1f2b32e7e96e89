#include "engine/script/step.h"

namespace campuswalk::engine {

bool is_instant(const Step& step) {
    return std::visit([]<typename Kind>(const Kind&) { return InstantStep<Kind>; }, step);
}

const SourceMark& mark_of(const Step& step) {
    return std::visit([](const auto& each) -> const SourceMark& { return each.mark; }, step);
}

StepPreview preview_of(const Step& step) {
    return std::visit([](const auto& each) { return each.preview(); }, step);
}

}  // namespace campuswalk::engine
