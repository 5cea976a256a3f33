// What a texel of 16-bit floats keeps of moments: 11 bits. Some drivers (Mesa's
// software ones) cut the others off, which pulls mean and variance down pass by
// pass: so they are rounded to nearest here, and the store changes nothing.
// needs: nothing
// offers: stored

vec2 stored(vec2 moments)
{
    // A float has 13 bits more. A tie goes to the even one; a carry is right.
    uvec2 bits = floatBitsToUint(moments);
    bits = (bits + 0xfffu + (bits >> 13 & 1u)) & 0xffffe000u;
    // Under 2^-14 all halves are 2^-24 apart.
    vec2 small = roundEven(moments * 16777216.0) / 16777216.0;
    return mix(uintBitsToFloat(bits), small,
               lessThan(moments, vec2(1.0 / 16384.0)));
}
