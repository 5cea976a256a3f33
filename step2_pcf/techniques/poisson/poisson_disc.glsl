// Where the taps of a disc are. No two of its points are near each other (a
// Poisson disc), so that a few of them see all of it. They are the centroids of
// their own Voronoi cells, scaled so that the mean of their squared radius is
// the disc's, 1/2.
// needs: nothing
// offers: poisson_tap, POISSON_TAPS, POISSON_RADIUS

const int POISSON_TAPS = 32;

// Half the least distance of two points: each stands for a disc of this radius.
const float POISSON_RADIUS = 0.1407;

const vec2 poisson_disc[POISSON_TAPS] = vec2[](
    vec2( 0.0043,  0.0175), vec2(-0.1701, -0.2224),
    vec2( 0.2233, -0.1762), vec2(-0.2932,  0.1247),
    vec2(-0.0104,  0.3231), vec2( 0.3193,  0.1560),
    vec2( 0.1434, -0.4974), vec2(-0.5436, -0.0716),
    vec2(-0.1777, -0.5274), vec2( 0.3302,  0.4703),
    vec2( 0.5783,  0.0208), vec2( 0.4759, -0.3331),
    vec2(-0.3617,  0.4560), vec2(-0.4623, -0.3626),
    vec2(-0.0408,  0.6193), vec2(-0.6032,  0.2327),
    vec2(-0.0734, -0.8306), vec2( 0.4835, -0.6847),
    vec2( 0.7307,  0.4153), vec2(-0.3919, -0.7465),
    vec2(-0.8113, -0.2540), vec2( 0.2243, -0.8202),
    vec2( 0.8441, -0.1986), vec2(-0.6591, -0.5639),
    vec2(-0.8698,  0.1011), vec2( 0.7282, -0.4951),
    vec2( 0.2432,  0.8496), vec2(-0.4568,  0.7594),
    vec2(-0.7371,  0.4976), vec2( 0.8796,  0.1317),
    vec2( 0.5696,  0.7056), vec2(-0.1155,  0.9037));

// (cos, sin) of 16 angles, ordered so that neighbours in 4 x 4 pixels differ.
const vec2 poisson_turns[16] = vec2[](
    vec2( 1.000000000,  0.000000000), vec2(-1.000000000,  0.000000000),
    vec2( 0.707106781,  0.707106781), vec2(-0.707106781, -0.707106781),
    vec2( 0.000000000, -1.000000000), vec2( 0.000000000,  1.000000000),
    vec2( 0.707106781, -0.707106781), vec2(-0.707106781,  0.707106781),
    vec2( 0.382683432,  0.923879533), vec2(-0.382683432, -0.923879533),
    vec2( 0.923879533,  0.382683432), vec2(-0.923879533, -0.382683432),
    vec2( 0.923879533, -0.382683432), vec2(-0.923879533,  0.382683432),
    vec2( 0.382683432, -0.923879533), vec2(-0.382683432,  0.923879533));

// Tap i of this pixel, in the unit disc. Each pixel turns the disc, else what
// its few taps miss would show as bands; turned, it is noise.
vec2 poisson_tap(int i)
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) & 3;
    vec2 turn = poisson_turns[4 * pixel.y + pixel.x];
    vec2 tap = poisson_disc[i];
    return vec2(turn.x * tap.x - turn.y * tap.y,
                turn.y * tap.x + turn.x * tap.y);
}
