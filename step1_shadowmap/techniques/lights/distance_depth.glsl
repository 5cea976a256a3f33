// In place of linear_depth.glsl: the depth t of a spot or point light is linear
// in the distance from it (only the last number of its row is not 0).
// Projective depth would crowd all that is far from the light into a last
// sliver below 1, where a variance says nothing.
// needs: towards_light
// offers: light_depth, depth_gradient

uniform vec4 depth_from_relative[8];  // a row for each layer
uniform float depth_per_distance;

float light_depth(vec3 relative_position, int layer)
{
    float along = dot(depth_from_relative[layer], vec4(relative_position, 1.0));
    float distance = length(towards_light(relative_position));
    return along + depth_per_distance * distance;
}

vec3 depth_gradient(vec3 relative_position, int layer)
{
    vec3 away = -normalize(towards_light(relative_position));
    return depth_from_relative[layer].xyz + depth_per_distance * away;
}
