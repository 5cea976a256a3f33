// The filter is as wide everywhere. pcf.c puts the width in front, a constant:
//     const int kernel;  texels, odd

int filter_width(Receiver receiver)
{
    return kernel;
}
