// What this pixel shows, as it is drawn.
// needs: nothing
// offers: viewer_normal, relative_position, albedo

in vec3 relative_position;  // of the point, to the camera
in vec3 surface_normal;     // in the world's axes, of any length
flat in vec3 albedo;        // linear RGB

// Unit, towards the viewer.
vec3 viewer_normal()
{
    return normalize(gl_FrontFacing ? surface_normal : -surface_normal);
}
