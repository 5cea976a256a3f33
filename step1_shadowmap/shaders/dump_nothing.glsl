// Without --dump there is nothing to keep.

void dump(Receiver receiver, vec3 relative_position, float lit)
{
}
