// Step 1: one comparison. Williams, Casting curved shadows on curved surfaces,
// SIGGRAPH 1978. (texelFetch() is the plain way to read one texel. Step 2 reads
// so many that Mesa's time counts: see map_depth.glsl.)
// needs: Receiver, comparison_bias
// offers: visibility

uniform sampler2DArray shadow_map;  // red: depth in [0, 1]

float visibility(Receiver receiver)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    ivec2 texel = min(ivec2(receiver.uv * vec2(size)), size - 1);  // for u = 1
    float occluder =
        texelFetch(shadow_map, ivec3(texel, receiver.layer), 0).r;
    float bias = comparison_bias(receiver, 1, vec2(size));
    return receiver.depth - bias <= occluder ? 1.0 : 0.0;
}
