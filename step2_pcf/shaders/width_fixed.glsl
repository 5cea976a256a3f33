// The filter is as wide everywhere.

uniform int kernel;  // texels, odd

int filter_width(Receiver receiver)
{
    return kernel;
}
