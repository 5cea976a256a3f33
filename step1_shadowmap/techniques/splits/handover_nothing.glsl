// Without --dump there is nothing to keep.
// needs: Receiver
// offers: dump_handover

void dump_handover(Receiver next, float share)
{
}
