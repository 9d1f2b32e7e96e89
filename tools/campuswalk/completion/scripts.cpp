#include "tools/campuswalk/completion/scripts.h"

#include <algorithm>

namespace campuswalk::tools::completion {

Offer offer_for(const KnownOption& option) {
    if (!option.choices.empty()) {
        return Offer::words;
    }
    return option.value == "FILE" ? Offer::files : option.value == "DIR" ? Offer::folders : Offer::nothing;
}

bool is_positional(const KnownOption& option) {
    return !option.names.empty() && !option.names.front().starts_with('-');
}

namespace {

void add_places(const std::string& path, const KnownCommand& command, std::vector<Place>& places) {
    places.push_back({path, &command});
    for (const KnownCommand& below : command.commands) {
        add_places(path + "/" + below.name, below, places);
    }
}

std::string value_cases(const Place& place, const std::function<std::string(const KnownOption&)>& reply) {
    std::string text;
    for (const KnownOption& option : place.command->options) {
        if (is_positional(option) || option.value.empty()) {
            continue;
        }
        std::vector<std::string> patterns;
        for (const std::string& spec : option.names) {
            patterns.push_back("'" + place.path + " " + spec + "'");
        }
        text += "        (" + joined(patterns, "|") + ") " + reply(option);
    }
    return text;
}

}  // namespace

std::vector<Place> places_of(const KnownCommand& program) {
    std::vector<Place> places;
    add_places("", program, places);
    return places;
}

std::string all_paths(const std::vector<Place>& places, std::string_view between) {
    std::vector<std::string> paths;
    for (const Place& place : places) {
        if (!place.path.empty()) {
            paths.push_back(place.path);
        }
    }
    return joined(paths, between);
}

std::vector<std::string> plain_words(const KnownCommand& command) {
    std::vector<std::string> words;
    for (const KnownCommand& below : command.commands) {
        words.push_back(below.name);
    }
    for (const KnownOption& option : command.options) {
        if (is_positional(option)) {
            words.insert(words.end(), option.choices.begin(), option.choices.end());
        }
    }
    return words;
}

bool takes_files(const KnownCommand& command) {
    return std::ranges::any_of(command.options, [](const KnownOption& option) {
        const Offer offer = offer_for(option);
        return is_positional(option) && (offer == Offer::files || offer == Offer::folders);
    });
}

std::string cases(const std::vector<Place>& places,
                  const std::function<std::string(const KnownOption&)>& reply,
                  const std::function<std::string(const Place&)>& words) {
    std::string text;
    for (const Place& place : places) {
        text += value_cases(place, reply);
    }
    text += "    esac\n    case \"$place\" in\n";
    for (const Place& place : places) {
        text += words(place);
    }
    return text;
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : std::string(between)) + word;
    }
    return text;
}

}  // namespace campuswalk::tools::completion
