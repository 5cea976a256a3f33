// In place of lookup_bilinear.glsl, where another file knows what is between
// the texels.

vec2 moments_at(Receiver receiver)
{
    return moments_between(receiver.uv, receiver.layer, 0.0);
}
