// --slope-term: the second moment of the depths across a texel, not only of the
// one in its middle.

layout(location = 0) out vec2 moments;

// Depths lie in [0, 1], so E[x^2] is at most E[x]: a limit to the slope of what
// the light sees edge on. What map_depth() cut off at 0 or 1 is flat there.
void main()
{
    float depth = map_depth(surface_position(), layer);
    float variance = depth > 0.0 && depth < 1.0 ? slope_variance(depth) : 0.0;
    moments = vec2(depth, min(depth * depth + variance, depth));
}
