// A shadow map: the depth of the surface nearest to the light.

in float depth;

layout(location = 0) out float nearest_depth;

void main()
{
    nearest_depth = depth;
}
