// Without --dump there is nothing to keep.
// needs: Receiver
// offers: dump

void dump(Receiver receiver, float lit)
{
}
