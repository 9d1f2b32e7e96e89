#include "scene/campus/object_names.h"

#include <map>
#include <set>
#include <utility>

#include "scene/base/ascii.h"

namespace campuswalk::scene {

std::string object_word(std::string_view node_name) {
    std::string word;
    bool gap = false;
    for (const char c : node_name) {
        const bool is_word_character = is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80;
        if (!is_word_character) {
            gap = true;
            continue;
        }
        if (gap && !word.empty()) {
            word += '-';
        }
        gap = false;
        word += to_lower(c);
    }
    return word.empty() ? "node" : word;
}

std::vector<std::string> numbered(std::vector<std::string> words) {
    std::set<std::string> taken(words.begin(), words.end());
    std::map<std::string, int> last_number;
    for (std::string& word : words) {
        int& number = last_number[word];
        if (++number == 1) {
            continue;  // the first keeps the plain word
        }
        std::string with_number = word + '-' + std::to_string(number);
        while (!taken.insert(with_number).second) {
            with_number = word + '-' + std::to_string(++number);
        }
        word = with_number;
    }
    return words;
}

std::vector<std::string> distinct_words(const std::vector<std::string>& node_names) {
    std::vector<std::string> words;
    words.reserve(node_names.size());
    for (const std::string& name : node_names) {
        words.push_back(object_word(name));
    }
    return numbered(std::move(words));
}

}  // namespace campuswalk::scene
