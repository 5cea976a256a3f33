// In place of the lesson's: a map for each part of the view.
// needs: Receiver, inside_map, visibility, viewer_normal, map_layer,
//     relative_position, next_layer_share, map_coordinates, layers,
//     towards_light, albedo, show, dump, dump_handover
// offers: color

uniform vec3 radiance;  // of the light, linear RGB
uniform vec3 ambient;   // from everywhere else, linear RGB

layout(location = 0) out vec4 color;

// What the map does not hold is lit.
float map_visibility(Receiver receiver)
{
    return inside_map(receiver) ? visibility(receiver) : 1.0;
}

// Where one layer hands over to the next, a mixture of what both say. After the
// last one there is only light.
float mixed_visibility(Receiver receiver, Receiver next, float share)
{
    float lit = map_visibility(receiver);
    if (share > 0.0) {
        float after = receiver.layer < next.layer ? map_visibility(next) : 1.0;
        lit = mix(lit, after, share);
    }
    return lit;
}

void main()
{
    vec3 normal = viewer_normal();
    int layer = map_layer(relative_position);
    float share = next_layer_share(relative_position);
    Receiver receiver = map_coordinates(relative_position, normal, layer);
    Receiver next = map_coordinates(relative_position, normal,
                                    min(layer + 1, layers - 1));
    float facing = dot(normal, normalize(towards_light(relative_position)));
    float lit =
        facing > 0.0 ? mixed_visibility(receiver, next, share) : 0.0;
    vec3 shaded = albedo * (ambient + radiance * (max(facing, 0.0) * lit));
    color = vec4(show(shaded, receiver, lit), 1.0);
    dump(receiver, lit);
    dump_handover(next, share);
}
