// --dump: what the next layer said, exactly as it was used.
// needs: Receiver
// offers: dump_handover

layout(location = 6) out vec4 dumped_handover;  // u, v, t in the next layer

void dump_handover(Receiver next, float share)
{
    dumped_handover = vec4(next.uv, next.depth, share);
}
