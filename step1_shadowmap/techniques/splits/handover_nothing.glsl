// Without --dump there is nothing to keep.

void dump_handover(Receiver next, float share)
{
}
