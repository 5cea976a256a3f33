// A point light has six views, along +x, -x, +y, -y, +z and -z: a position
// belongs to that of its largest coordinate as seen from the light.
// needs: towards_light
// offers: map_layer

int map_layer(vec3 relative_position)
{
    vec3 from_light = -towards_light(relative_position);
    vec3 size = abs(from_light);
    int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (from_light[axis] < 0.0 ? 1 : 0);
}
