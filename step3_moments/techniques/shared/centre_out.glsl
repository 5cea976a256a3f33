// What a fragment of the map gets: the position at its texel's centre.
// needs: nothing
// offers: hand_on, relative_position

out vec3 relative_position;

void hand_on(vec4 position)
{
    relative_position = position.xyz;
}
