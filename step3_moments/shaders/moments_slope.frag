// --slope-term: the moments of the depths across a texel, not only of the one
// in its middle.

layout(location = 0) out vec2 moments;

// What map_depth() cut off at 0 or 1 is flat there. moments_of() limits the
// slope of what the light sees edge on.
void main()
{
    float depth = map_depth(relative_position, layer);
    float variance = depth > 0.0 && depth < 1.0 ? slope_variance(depth) : 0.0;
    moments = stored(moments_of(depth, variance));
}
