// Where the light is, and the depth t: one formula for the map and the picture.
// needs: light_depth
// offers: towards_light, map_depth, map_from_relative, light_position

uniform mat4 map_from_relative[8];  // to (u w, v w, z w, w): base/light/view.h
uniform vec4 light_position;  // relative, 1; or towards a parallel light, 0

// Its length is the distance of a spot or point light, 1 for a parallel one.
vec3 towards_light(vec3 relative_position)
{
    return light_position.xyz - light_position.w * relative_position;
}

// t of a position in a layer.
float light_depth(vec3 relative_position, int layer);

// What the map keeps of t: 0 before the near plane, 1 behind the far plane.
float map_depth(vec3 relative_position, int layer)
{
    return clamp(light_depth(relative_position, layer), 0.0, 1.0);
}
