// --dump with --msaa: the moments of one sample of each texel.
// needs: nothing
// offers: moments

uniform sampler2DMS samples;
uniform int index;  // of the sample

layout(location = 0) out vec2 moments;

void main()
{
    moments = texelFetch(samples, ivec2(gl_FragCoord.xy), index).rg;
}
