// The position at the texel's centre.
// needs: nothing
// offers: relative_position

in vec3 relative_position;
