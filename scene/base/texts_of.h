#pragma once

#include <functional>
#include <string>
#include <vector>

namespace campuswalk::scene {

/// A text of each element, such as `texts_of(campus.objects, &CampusObject::id)`.
template <typename Elements, typename Member>
std::vector<std::string> texts_of(const Elements& elements, Member member) {
    std::vector<std::string> texts;
    for (const auto& element : elements) {
        texts.emplace_back(std::invoke(member, element));
    }
    return texts;
}

}  // namespace campuswalk::scene
