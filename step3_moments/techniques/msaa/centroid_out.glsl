// --msaa: a triangle may cover some samples of a texel and not its centre.
// There its plane may have any depth, before the light or behind everything. So
// a fragment gets the position at a place that its triangle covers, the centre
// where that is all.
// needs: nothing
// offers: hand_on, covered_position

centroid out vec4 covered_position;

// Its last number is 1, and is interpolated too: see centroid_in.glsl. (Written
// as 1.0 here, it would reach the fragments without.)
void hand_on(vec4 position)
{
    covered_position = position;
}
