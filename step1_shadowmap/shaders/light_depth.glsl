// Where the light is, and what a map keeps of the depth t that it and the
// picture compare: one formula for both. linear_depth.glsl has it.
// needs: light_depth
// offers: towards_light, map_depth, map_from_relative, light_position

uniform mat4 map_from_relative[8];  // to (u w, v w, z w, w), see view.h
uniform vec4 light_position;  // relative, 1; or towards a parallel light, 0

// Its length is the distance of a spot or point light, 1 for a parallel one.
vec3 towards_light(vec3 relative_position)
{
    return light_position.xyz - light_position.w * relative_position;
}

// t of a position in a layer.
float light_depth(vec3 relative_position, int layer);

// What the map keeps of it: what is before the near plane, and casts from
// there, is at 0; what is behind the far plane is as far as nothing.
float map_depth(vec3 relative_position, int layer)
{
    return clamp(light_depth(relative_position, layer), 0.0, 1.0);
}
