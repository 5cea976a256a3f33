// --dump: what the picture was made from, exactly as it was used.
// needs: Receiver
// offers: dump

layout(location = 1) out vec4 dumped_receiver;  // u, v, t, layer
layout(location = 2) out vec3 dumped_position;
layout(location = 3) out vec3 dumped_normal;
layout(location = 4) out float dumped_visibility;

void dump(Receiver receiver, float lit)
{
    dumped_receiver = vec4(receiver.uv, receiver.depth, float(receiver.layer));
    dumped_position = receiver.relative_position;
    dumped_normal = receiver.normal;
    dumped_visibility = lit;
}
