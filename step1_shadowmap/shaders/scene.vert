// The scene as the camera sees it.
// needs: nothing
// offers: gl_Position, relative_position, surface_normal, albedo

uniform mat4 clip_from_relative;

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 object_normal;
// These are the same for all vertices of an object:
layout(location = 2) in mat4x3 relative_from_object;  // relative to the camera
layout(location = 6) in mat3 normal_from_object;      // to the world's axes
layout(location = 9) in vec3 object_albedo;           // linear RGB

out vec3 relative_position;
out vec3 surface_normal;
flat out vec3 albedo;

void main()
{
    relative_position = relative_from_object * vec4(object_position, 1.0);
    surface_normal = normal_from_object * object_normal;
    albedo = object_albedo;
    gl_Position = clip_from_relative * vec4(relative_position, 1.0);
}
