// Gives every fragment of a triangle the triangle's own normal.

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec3 relative_position[];

out vec3 plane_position;
flat out vec3 plane_normal;

void main()
{
    vec3 normal = cross(relative_position[1] - relative_position[0],
                        relative_position[2] - relative_position[0]);
    for (int i = 0; i < 3; i++) {
        gl_Position = gl_in[i].gl_Position;
        plane_position = relative_position[i];
        plane_normal = normalize(normal);
        EmitVertex();
    }
    EndPrimitive();
}
