// --depth projected: t is z / w, what a depth buffer holds. For a parallel
// light w is 1 and this is the linear depth. For a spot or point light with the
// distance d along the view's axis it is far / (far - near) (1 - near / d): far
// from the light it hardly changes any more.
// needs: map_from_relative
// offers: light_depth, depth_gradient

// Row i of the matrix to (u w, v w, z w, w).
vec4 map_row(int layer, int i)
{
    mat4 m = map_from_relative[layer];
    return vec4(m[0][i], m[1][i], m[2][i], m[3][i]);
}

float light_depth(vec3 relative_position, int layer)
{
    vec4 position = vec4(relative_position, 1.0);
    return dot(map_row(layer, 2), position) / dot(map_row(layer, 3), position);
}

vec3 depth_gradient(vec3 relative_position, int layer)
{
    float t = light_depth(relative_position, layer);
    vec4 along = map_row(layer, 3);
    float w = dot(along, vec4(relative_position, 1.0));
    return (map_row(layer, 2).xyz - t * along.xyz) / w;
}
