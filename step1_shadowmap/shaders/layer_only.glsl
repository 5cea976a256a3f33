// A light with one view has one layer.

const int layers = 1;  // of the map

int map_layer(vec3 relative_position)
{
    return 0;
}

// Of the next layer, where two are mixed: there are no such places.
float next_layer_share(vec3 relative_position)
{
    return 0.0;
}
