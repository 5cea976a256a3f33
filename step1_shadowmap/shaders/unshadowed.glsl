// --shadows off: nothing is in the way of the light.

float visibility(Receiver receiver)
{
    return 1.0;
}
