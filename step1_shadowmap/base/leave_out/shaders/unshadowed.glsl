// --shadows off, and where no visible receiver is in a map: there is nothing to
// look up.
// needs: Receiver
// offers: visibility

float visibility(Receiver receiver)
{
    return 1.0;
}
