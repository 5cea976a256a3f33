// In place of lookup_bilinear.glsl, where another file knows what is between
// the texels.
// needs: Receiver, moments_between
// offers: moments_at

vec2 moments_at(Receiver receiver)
{
    return moments_between(receiver.uv, receiver.layer, 0.0);
}
