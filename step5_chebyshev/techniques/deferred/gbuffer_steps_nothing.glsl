// No lookup asks for the footprint.
// needs: nothing
// offers: store_steps

void store_steps()
{
}
