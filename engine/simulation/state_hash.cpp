#include "engine/simulation/state_hash.h"

#include <string>
#include <variant>

namespace campuswalk::engine {

namespace {

void add_value(StateHash& hash, std::int64_t value) {
    hash.add(static_cast<std::uint64_t>(value));
}
void add_value(StateHash& hash, const Decimal& value) {
    hash.add(value.value);
}
void add_value(StateHash& hash, const Eigen::Vector3d& value) {
    hash.add(value);
}
void add_value(StateHash& hash, const std::string& value) {
    hash.add(std::string_view(value));
}
void add_value(StateHash& hash, const Text& value) {
    hash.add(std::string_view(value.value));
}
void add_value(StateHash& hash, const std::shared_ptr<const Reason>& value) {
    hash.add(std::string_view(text_of(*value)));
}

}  // namespace

void StateHash::add(const Event& event) {
    add(static_cast<std::uint64_t>(event.kind));
    add(event.at);
    add(std::string_view(event.object));
    for (const Field& field : event.fields) {
        if (field.name != kWhy) {
            add(field.name);
            std::visit([&](const auto& value) { add_value(*this, value); }, field.value);
        }
    }
}

}  // namespace campuswalk::engine
