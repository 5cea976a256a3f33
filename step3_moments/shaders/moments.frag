// Step 3: the first two moments of the depth's distribution. One texel holds
// one depth, so here M2 is only its square; it cannot be had from M1 any more
// once texels have been averaged.
// needs: map_depth
// offers: moments

uniform int layer;

in vec3 relative_position;

layout(location = 0) out vec2 moments;

void main()
{
    float depth = map_depth(relative_position, layer);
    moments = vec2(depth, depth * depth);
}
