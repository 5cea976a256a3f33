// What triangle_plane.geom gets: the positions of a triangle's corners.
// needs: nothing
// offers: hand_on, corner_position

out vec4 corner_position;

void hand_on(vec4 position)
{
    corner_position = position;
}
