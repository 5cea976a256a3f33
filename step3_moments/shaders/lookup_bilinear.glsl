// The moments where a point of the picture is in the map, between texels.

vec2 moments_at(Receiver receiver)
{
    return moments_between(receiver.uv, receiver.layer, 0.0);
}
