// Shading, the same in every step: what differs is visibility().

uniform vec3 albedo;    // linear RGB
uniform vec3 radiance;  // of the light, linear RGB
uniform vec3 ambient;   // from everywhere else, linear RGB
uniform vec3 to_light;  // unit, in the world's axes

in vec3 surface_normal;

layout(location = 0) out vec4 color;

void main()
{
    vec3 normal = normalize(gl_FrontFacing ? surface_normal : -surface_normal);
    Receiver receiver = map_coordinates(relative_position, normal);
    float facing = dot(normal, to_light);
    float lit = facing > 0.0 ? 1.0 : 0.0;
    if (facing > 0.0 && inside_map(receiver)) {
        lit = visibility(receiver);
    }
    vec3 shaded = albedo * (ambient + radiance * max(facing, 0.0) * lit);
    color = vec4(show(shaded, receiver, lit), 1.0);
    dump(receiver, relative_position, lit);
}
