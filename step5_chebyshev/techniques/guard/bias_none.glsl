// Nothing is added to a variance but its guard.

float biased(float variance)
{
    return variance;
}
