// In place of dump.glsl where a lookup asks for the footprint.
// needs: Receiver, footprint
// offers: dump

layout(location = 1) out vec4 dumped_receiver;  // u, v, t, layer
layout(location = 2) out vec3 dumped_position;
layout(location = 3) out vec3 dumped_normal;
layout(location = 4) out float dumped_visibility;
layout(location = 5) out vec4 dumped_footprint;

void dump(Receiver receiver, float lit)
{
    dumped_receiver = vec4(receiver.uv, receiver.depth, float(receiver.layer));
    dumped_position = receiver.relative_position;
    dumped_normal = receiver.normal;
    dumped_visibility = lit;
    dumped_footprint = footprint(receiver);
}
