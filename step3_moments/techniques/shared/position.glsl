// The position at the texel's centre.

in vec3 relative_position;
