// The depth t that the map holds and the picture compares with: one formula
// for both. It is linear, 0 at the view's near plane and 1 at its far plane:
// along the direction of a parallel light (its depth_per_distance is 0), else
// the distance from the light (only the last number of its row is not 0).
// Projective depth would crowd all that is far from the light into a last
// sliver below 1, where a variance says nothing.

uniform vec4 depth_from_relative[8];  // a row for each layer
uniform float depth_per_distance;
uniform int layers;           // of the map
uniform vec4 light_position;  // relative, 1; or towards a parallel light, 0

// Its length is the distance of a spot or point light, 1 for a parallel one.
vec3 towards_light(vec3 relative_position)
{
    return light_position.xyz - light_position.w * relative_position;
}

float light_depth(vec3 relative_position, int layer)
{
    float along = dot(depth_from_relative[layer], vec4(relative_position, 1.0));
    float distance = length(towards_light(relative_position));
    return along + depth_per_distance * distance;
}

// What the map keeps of it: what is before the near plane, and casts from
// there, is at 0; what is behind the far plane is as far as nothing.
float map_depth(vec3 relative_position, int layer)
{
    return clamp(light_depth(relative_position, layer), 0.0, 1.0);
}
