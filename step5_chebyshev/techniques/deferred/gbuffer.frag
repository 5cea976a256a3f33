// --deferred, first pass: what each pixel shows, stored for the second one.
// needs: relative_position, viewer_normal, albedo, store_steps
// offers: stored_position, stored_normal, stored_albedo

layout(location = 0) out vec3 stored_position;  // relative to the camera
layout(location = 1) out vec3 stored_normal;    // unit, towards the viewer
layout(location = 2) out vec3 stored_albedo;    // linear RGB

void main()
{
    stored_position = relative_position;
    stored_normal = viewer_normal();
    stored_albedo = albedo;
    store_steps();
}
