// Where a point of the picture is in the shadow map, and how deep.
// needs: map_from_relative, light_depth
// offers: Receiver, map_coordinates, inside_map

struct Receiver {
    vec2 uv;      // in [0, 1] across the map; v grows upwards
    float depth;  // t in [0, 1] from the near to the far plane
    int layer;    // of the map
    vec3 normal;  // unit, towards the viewer, in the world's axes
    vec3 relative_position;
};

// Dividing by w makes a perspective of what a spot or point light sees; for a
// parallel light it is 1.
Receiver map_coordinates(vec3 relative_position, vec3 normal, int layer)
{
    vec4 map_position = map_from_relative[layer] * vec4(relative_position, 1.0);
    return Receiver(map_position.xy / map_position.w,
                    light_depth(relative_position, layer), layer, normal,
                    relative_position);
}

bool inside_map(Receiver receiver)
{
    vec3 position = vec3(receiver.uv, receiver.depth);
    return all(greaterThanEqual(position, vec3(0.0))) &&
           all(lessThanEqual(position, vec3(1.0)));
}
