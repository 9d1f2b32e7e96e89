#pragma once

#include <string>

namespace pugi {
class xml_document;
}

namespace campuswalk::scene {

/// What is wrong with the numbers of a COLLADA file's meshes; empty if nothing is. assimp 5.2.5 reads beyond
/// arrays that are shorter than their accessors say, and never gets past a word among indices.
std::string collada_fault(pugi::xml_document& document);

}  // namespace campuswalk::scene
