// The depth t is linear along the light: 0 at the near plane, 1 at the far one.
// needs: nothing
// offers: light_depth, depth_gradient

uniform vec4 depth_from_relative[8];  // a row for each layer

float light_depth(vec3 relative_position, int layer)
{
    return dot(depth_from_relative[layer], vec4(relative_position, 1.0));
}

// How t changes with the position.
vec3 depth_gradient(vec3 relative_position, int layer)
{
    return depth_from_relative[layer].xyz;
}
