// The scene as the light sees it, one layer of its map at a time.

uniform mat4 relative_from_object;  // to positions relative to the camera
uniform mat4 map_from_relative[8];  // to (u, v, t), each in [0, 1]
uniform int layer;

layout(location = 0) in vec3 object_position;

out float depth;  // t: 0 at the view's near plane, 1 at its far plane

void main()
{
    vec4 relative = relative_from_object * vec4(object_position, 1.0);
    vec3 map_position = (map_from_relative[layer] * relative).xyz;
    depth = map_position.z;
    gl_Position = vec4(2.0 * map_position - 1.0, 1.0);
}
