// In place of the lesson's: a light that is somewhere, and maybe a cone.
// needs: Receiver, inside_map, visibility, viewer_normal, map_layer,
//     relative_position, map_coordinates, towards_light, albedo, show, dump
// offers: color

uniform vec3 radiance;  // of the light, linear RGB
uniform vec3 ambient;   // from everywhere else, linear RGB
uniform float reference_distance;  // where the radiance holds
uniform vec3 cone_axis;            // of a spot light, unit
uniform vec2 cone_spreads;         // at its edge, and where it is full bright

layout(location = 0) out vec4 color;

// 1 - the cosine of the angle between two unit vectors. In a narrow cone all
// cosines are so near 1 that a float hardly tells its edge from its middle.
float spread_between(vec3 a, vec3 b)
{
    vec3 apart = a - b;
    return 0.5 * dot(apart, apart);
}

// How much of the radiance arrives: it falls with the square of the distance,
// and from the middle of a spot's cone to its edge.
float falloff(float distance, float spread)
{
    float part = reference_distance / distance;
    float cone = clamp((spread - cone_spreads.x) /
                           (cone_spreads.y - cone_spreads.x), 0.0, 1.0);
    return part * part * cone * cone;
}

// What the map does not hold is lit.
float map_visibility(Receiver receiver)
{
    return inside_map(receiver) ? visibility(receiver) : 1.0;
}

void main()
{
    vec3 normal = viewer_normal();
    int layer = map_layer(relative_position);
    Receiver receiver = map_coordinates(relative_position, normal, layer);
    vec3 towards = towards_light(relative_position);
    vec3 to_light = normalize(towards);
    float facing = dot(normal, to_light);
    float spread = spread_between(cone_axis, -to_light);
    float lit = facing > 0.0 && spread < cone_spreads.x
                    ? map_visibility(receiver) : 0.0;
    float arriving = max(facing, 0.0) * lit * falloff(length(towards), spread);
    vec3 shaded = albedo * (ambient + radiance * arriving);
    color = vec4(show(shaded, receiver, lit), 1.0);
    dump(receiver, lit);
}
