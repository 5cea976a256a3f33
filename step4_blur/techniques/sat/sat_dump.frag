// --dump: what the table gives at every texel's centre.
// needs: box_mean
// offers: moments

uniform int layer;
uniform float box_width;  // texels

layout(location = 0) out vec2 moments;

void main()
{
    moments = box_mean(gl_FragCoord.xy, layer, box_width);
}
