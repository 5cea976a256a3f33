// --variance-bias X: added to every variance, which is then at most 1.
// needs: from variance_bias.c:
//     const float variance_bias;  of the squared depth range
// offers: biased

float biased(float variance)
{
    return min(variance + variance_bias, 1.0);
}
