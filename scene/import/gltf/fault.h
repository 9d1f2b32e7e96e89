#pragma once

#include <stdexcept>
#include <string>

namespace campuswalk::scene::gltf {

/// What is wrong with a glTF file, in words; GltfSource makes an InputError of it.
class Fault : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace campuswalk::scene::gltf
