// Where a lookup asks for the pixel's footprint, the derivatives of the position
// are stored too. They are known only while a triangle is drawn: the second
// pass would take the difference across an outline, to another object.
// needs: to_right, to_above
// offers: store_steps

layout(location = 3) out vec3 stored_right;
layout(location = 4) out vec3 stored_above;

void store_steps()
{
    stored_right = to_right;
    stored_above = to_above;
}
