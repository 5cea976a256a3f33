// The filter is as wide everywhere.
// needs: Receiver; from pcf.c:
//     const int kernel;  texels, odd
// offers: filter_width

int filter_width(Receiver receiver)
{
    return kernel;
}
