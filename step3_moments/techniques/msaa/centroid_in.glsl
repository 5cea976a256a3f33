// --msaa: the position at a place in the texel that the triangle covers.
// needs: nothing
// offers: relative_position

centroid in vec4 covered_position;

// In a perspective view a driver interpolates x / w and multiplies by w. Mesa's
// llvmpipe takes the one at the place and the other at the centre, which puts
// the position beside its triangle, and the 1 off by the same factor.
vec3 relative_position = covered_position.xyz / covered_position.w;
