// The scene as the light sees it, one layer of its map at a time.
// needs: nothing
// offers: gl_Position, relative_position

uniform mat4 map_from_relative[8];  // to (u w, v w, z w, w): base/light/view.h
uniform int layer;

layout(location = 0) in vec4 object_position;  // its last number is 1
layout(location = 2) in mat4x3 relative_from_object;  // one for each object

out vec3 relative_position;

void main()
{
    relative_position = relative_from_object * object_position;
    vec4 map_position = map_from_relative[layer] * vec4(relative_position, 1.0);
    gl_Position =
        vec4(2.0 * map_position.xyz - map_position.w, map_position.w);
}
