// --variance-bias X: added to every variance, which is then at most 1.
//
// variance_bias.c puts a constant in front:
//     const float variance_bias;  of the squared depth range

float biased(float variance)
{
    return min(variance + variance_bias, 1.0);
}
