// The depth t is linear along the light's direction, 0 at the view's near plane
// and 1 at its far plane.

uniform vec4 depth_from_relative[8];  // a row for each layer

float light_depth(vec3 relative_position, int layer)
{
    return dot(depth_from_relative[layer], vec4(relative_position, 1.0));
}

vec3 depth_gradient(vec3 relative_position, int layer)
{
    return depth_from_relative[layer].xyz;
}
