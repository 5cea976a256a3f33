// What a texel of 32-bit floats keeps of moments: all of it. (Raw moments in 16
// bits are left to the driver, as published: some cut them off.)
// needs: nothing
// offers: stored

vec2 stored(vec2 moments)
{
    return moments;
}
