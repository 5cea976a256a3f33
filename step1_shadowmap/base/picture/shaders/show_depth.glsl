// --show depth: how deep each point is, as the light sees it.
// needs: Receiver, scale_color
// offers: show

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    return scale_color(receiver.depth);
}
