// Gives every fragment of a triangle the triangle's own normal, and hands its
// position on.
// needs: hand_on
// offers: gl_Position, plane_normal

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec4 corner_position[];

flat out vec3 plane_normal;

void main()
{
    vec3 first = corner_position[0].xyz;
    vec3 normal = cross(corner_position[1].xyz - first,
                        corner_position[2].xyz - first);
    for (int i = 0; i < 3; i++) {
        gl_Position = gl_in[i].gl_Position;
        hand_on(corner_position[i]);
        plane_normal = normalize(normal);
        EmitVertex();
    }
    EndPrimitive();
}
