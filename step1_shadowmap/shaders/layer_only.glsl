// A light with one view has one layer.

int map_layer(vec3 relative_position)
{
    return 0;
}
