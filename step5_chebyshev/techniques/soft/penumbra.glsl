// --soft: how wide the penumbra is at a receiver. Fernando, Percentage-closer
// soft shadows, SIGGRAPH 2005, with the occluders' mean depth of Yang, Dong,
// Feng, Seidel, Kautz, Variance soft shadow mapping, 2010.
// needs: light_position, Receiver, map_from_relative, map_gradient,
//     towards_light, depth_slope, moments_at_level, variance_of, guarded,
//     chebyshev, biased, shadow_map
// offers: Disc, penumbra_disc, LEAST_DISC

uniform float light_size;  // its diameter, of a parallel light at a distance
                           // of 1; world units
uniform float penumbra_scale;
uniform vec4 distance_of_depth[8];

// No disc is smaller, in texels: edges in the map have steps of one texel.
const float LEAST_DISC = 4.0;
// None is larger, as part of the map: the border leaves room for that.
const float LARGEST_DISC = 1.0 / 8.0;
// Areas that are searched for occluders, from the widest to the least.
const int SEARCHES = 3;

// Where a lookup finds what a disc in the map holds on average.
struct Disc {
    bool lit;      // nothing is in the way: there is no disc
    mat2 uv_step;  // from the unit disc
    float texels;  // its diameter
    float gap;     // from the occluders to the receiver, in texels
};

// From the light, of a parallel one along its direction from the near plane.
float light_distance(float t, int layer)
{
    vec4 c = distance_of_depth[layer];
    return (c.x + c.y * t) / (c.z + c.w * t);
}

// What an edge at one distance makes of the light at another, in world units
// across the light's rays.
float penumbra_width(float receiver, float occluder)
{
    float gap = receiver - occluder;
    return light_size * (light_position.w == 0.0
                             ? gap : gap / max(occluder, 1e-6 * receiver));
}

// How u and v change along two directions that are across the light's ray and
// across each other: a circle that faces the light is an ellipse in the map of
// a spot or point light.
mat2 map_of_circle(Receiver receiver)
{
    vec4 map_position = map_from_relative[receiver.layer] *
                        vec4(receiver.relative_position, 1.0);
    vec3 u = map_gradient(map_position, receiver.layer, 0);
    vec3 v = map_gradient(map_position, receiver.layer, 1);
    vec3 across = normalize(u);
    vec3 up = normalize(cross(towards_light(receiver.relative_position), u));
    return mat2(dot(u, across), dot(v, across), dot(u, up), dot(v, up));
}

// The moments of an area around the receiver, from one lookup. It sees a bell
// whose standard deviation is 0.65 of its level's texels; a disc's is a quarter
// of its diameter. The bound takes what is lit to be at one depth: what the
// receiver's own plane varies by is taken off, but for a tenth, which keeps a
// curved surface lit.
vec2 area_moments(Receiver receiver, float diameter, vec2 size)
{
    float texels = max(diameter / 2.6, 1.0);
    vec2 slope = depth_slope(receiver.relative_position, receiver.normal,
                             receiver.layer) / size;
    vec2 moments =
        moments_at_level(receiver.uv, receiver.layer, log2(texels));
    float deviation = 0.65 * texels * length(slope);
    float variance = max(variance_of(moments), 0.0);
    return moments -
           vec2(0.0, min(deviation * deviation, 0.9 * variance));
}

// How far before the receiver, in t, the occluders are on average: with p of an
// area lit, at the receiver's own depth t, and the rest at z, the mean M1 is
// p t + (1 - p) z, so t - z is (t - M1) / (1 - p). What is deeper than the
// receiver hides all this: a small thing's shadow on a raised surface would be
// lost to a search as wide as the light. So narrower areas are added to it. 0
// where no more than one part in 100 is in the way.
float occluder_gap(Receiver receiver, float widest, vec2 size)
{
    float before = 0.0;
    float hidden = 0.0;
    for (int i = 0; i < SEARCHES; i++) {
        float part = float(i) / float(SEARCHES - 1);
        vec2 moments = area_moments(
            receiver, widest * pow(LEAST_DISC / widest, part), size);
        vec2 depths = guarded(moments, receiver);
        before += max(receiver.depth - depths.x, 0.0);
        hidden +=
            1.0 - chebyshev(depths.x, biased(depths.y), receiver.depth);
    }
    return hidden > 0.01 ? before / hidden : 0.0;
}

Disc penumbra_disc(Receiver receiver)
{
    vec2 size = vec2(textureSize(shadow_map, 0).xy);
    mat2 uv_step = map_of_circle(receiver);
    float texels = sqrt(abs(determinant(uv_step)) * size.x * size.y);
    float here = light_distance(receiver.depth, receiver.layer);
    float nearest = light_distance(0.0, receiver.layer);
    float widest = penumbra_width(here, nearest) * texels;
    widest = max(min(widest, LARGEST_DISC * min(size.x, size.y)), LEAST_DISC);
    float gap = occluder_gap(receiver, widest, size);
    if (gap == 0.0) {
        return Disc(true, mat2(0.0), 0.0, 0.0);
    }
    float occluder =
        light_distance(max(receiver.depth - gap, 0.0), receiver.layer);
    float width = penumbra_scale * penumbra_width(here, occluder) * texels;
    width = clamp(width, LEAST_DISC, widest);
    return Disc(false, 0.5 * width / texels * uv_step, width,
                (here - occluder) * texels);
}
