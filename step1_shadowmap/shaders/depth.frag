// A shadow map: the depth of the surface nearest to the light.
// needs: map_depth
// offers: nearest_depth

uniform int layer;

in vec3 relative_position;

layout(location = 0) out float nearest_depth;

void main()
{
    nearest_depth = map_depth(relative_position, layer);
}
