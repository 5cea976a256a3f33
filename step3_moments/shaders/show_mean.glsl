// --show mean: the mean depth M1 that the map holds where each point looks it
// up. Where it is darker than --show depth, something is nearer to the light.
// needs: Receiver, scale_color, moments_at
// offers: show

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    return scale_color(moments_at(receiver).x);
}
