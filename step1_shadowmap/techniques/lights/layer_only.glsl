// A spot light has one view, and its map one layer.
// needs: nothing
// offers: map_layer

int map_layer(vec3 relative_position)
{
    return 0;
}
