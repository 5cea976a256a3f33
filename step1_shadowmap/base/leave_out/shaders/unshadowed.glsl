// --shadows off, and where no visible receiver is in a map: there is nothing to
// look up.

float visibility(Receiver receiver)
{
    lookups = 0;
    return 1.0;
}
