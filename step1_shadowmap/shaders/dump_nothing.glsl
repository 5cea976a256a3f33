// Without --dump there is nothing to keep.

void dump(Receiver receiver, Receiver next, float share, float lit)
{
}
