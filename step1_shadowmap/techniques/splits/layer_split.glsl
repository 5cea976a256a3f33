// Parallel splits: a position belongs to the first one that reaches as far as
// the camera sees it. In the last part of a split the next one takes over,
// else the change of the texels' size would show as a line; after the last one
// there is only light.
// needs: nothing
// offers: map_layer, next_layer_share, layers

uniform int layers;  // of the map
uniform mat4 clip_from_relative;
uniform vec2 split_range[8];  // view depths: the hand-over begins, and ends

float view_depth(vec3 relative_position)
{
    return (clip_from_relative * vec4(relative_position, 1.0)).w;
}

int map_layer(vec3 relative_position)
{
    float depth = view_depth(relative_position);
    int layer = 0;
    while (layer + 1 < layers && depth > split_range[layer].y) {
        layer++;
    }
    return layer;
}

float next_layer_share(vec3 relative_position)
{
    int layer = map_layer(relative_position);
    return smoothstep(split_range[layer].x, split_range[layer].y,
                      view_depth(relative_position));
}
