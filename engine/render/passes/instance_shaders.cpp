#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kInstanceChunk = R"(
layout(location = 4) in vec4 instance_x;  // rows of Instance
layout(location = 5) in vec4 instance_y;
layout(location = 6) in vec4 instance_z;
layout(location = 7) in uint instance_node;

vec3 placed(vec3 position) {
    vec4 p = vec4(position, 1.0);
    return vec3(dot(instance_x, p), dot(instance_y, p), dot(instance_z, p));
}

// As long as the instance is large: it is the same for all vertices of a triangle.
vec3 turned(vec3 normal) {
    return vec3(dot(instance_x.xyz, normal), dot(instance_y.xyz, normal), dot(instance_z.xyz, normal));
}
)";

}  // namespace campuswalk::engine::render::shaders
