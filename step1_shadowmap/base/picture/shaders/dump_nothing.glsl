// Without --dump there is nothing to keep.

void dump(Receiver receiver, float lit)
{
}
