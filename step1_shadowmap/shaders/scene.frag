// Shading, the same in every step: what differs is visibility().
// needs: Receiver, inside_map, visibility, viewer_normal, map_coordinates,
//     relative_position, towards_light, albedo, show, dump
// offers: color

uniform vec3 radiance;  // of the light, linear RGB
uniform vec3 ambient;   // from everywhere else, linear RGB

layout(location = 0) out vec4 color;

// What the map does not hold is lit.
float map_visibility(Receiver receiver)
{
    return inside_map(receiver) ? visibility(receiver) : 1.0;
}

void main()
{
    vec3 normal = viewer_normal();
    Receiver receiver = map_coordinates(relative_position, normal, 0);
    float facing = dot(normal, normalize(towards_light(relative_position)));
    float lit = facing > 0.0 ? map_visibility(receiver) : 0.0;
    vec3 shaded = albedo * (ambient + radiance * (max(facing, 0.0) * lit));
    color = vec4(show(shaded, receiver, lit), 1.0);
    dump(receiver, lit);
}
