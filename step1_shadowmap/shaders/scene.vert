// The scene as the camera sees it.

uniform mat4 relative_from_object;  // to positions relative to the camera
uniform mat4 clip_from_relative;
uniform mat3 normal_from_object;    // to the world's axes

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 object_normal;

out vec3 relative_position;
out vec3 surface_normal;

void main()
{
    vec4 relative = relative_from_object * vec4(object_position, 1.0);
    relative_position = relative.xyz;
    surface_normal = normal_from_object * object_normal;
    gl_Position = clip_from_relative * relative;
}
