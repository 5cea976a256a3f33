// How far it is to what the next pixels show.
// needs: relative_position
// offers: to_right, to_above

// A derivative has no value in a branch that a neighbour may not take, so both
// are taken here, before main() begins.
vec3 to_right = dFdx(relative_position);
vec3 to_above = dFdy(relative_position);
