// In place of map.vert: what the next shader gets, hand_on() says.
// needs: hand_on
// offers: gl_Position

uniform mat4 map_from_relative[8];  // to (u w, v w, z w, w): base/light/view.h
uniform int layer;

layout(location = 0) in vec4 object_position;  // its last number is 1
layout(location = 2) in mat4x3 relative_from_object;  // one for each object

void main()
{
    vec3 relative = relative_from_object * object_position;
    hand_on(vec4(relative, object_position.w));
    vec4 map_position = map_from_relative[layer] * vec4(relative, 1.0);
    gl_Position =
        vec4(2.0 * map_position.xyz - map_position.w, map_position.w);
}
