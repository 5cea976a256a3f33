// Steps 3 and 4: one comparison with the mean depth. A mean is not a depth of
// anything: this is what step 5 mends.

uniform sampler2DArray shadow_map;  // red, green: moments M1, M2 of the depth

float visibility(Receiver receiver)
{
    vec2 moments =
        texture(shadow_map, vec3(receiver.uv, float(receiver.layer))).rg;
    vec2 size = vec2(textureSize(shadow_map, 0).xy);
    float bias = comparison_bias(receiver, 1, size);
    return receiver.depth - bias <= moments.x ? 1.0 : 0.0;
}
