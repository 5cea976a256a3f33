// Nothing is added to a variance but its guard.
// needs: nothing
// offers: biased

float biased(float variance)
{
    return variance;
}
