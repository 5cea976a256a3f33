// --show plan: how often each pixel had to look a map up, as a hue over the
// shaded picture. Grey: its visibility was known.
// needs: Receiver, visibility, scale_color
// offers: show

int lookups = 0;  // so far, for this pixel

float counted_visibility(Receiver receiver)
{
    lookups++;
    return visibility(receiver);
}

// For the file behind this one, scene.frag or what stands in its place.
#define visibility counted_visibility

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    float brightness = dot(shaded, vec3(0.3, 0.5, 0.2));
    return (0.2 + 1.6 * brightness) * scale_color(0.5 * float(lookups));
}
