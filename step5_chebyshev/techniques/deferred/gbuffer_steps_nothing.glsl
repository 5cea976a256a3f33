// No lookup asks for the footprint.

void store_steps()
{
}
