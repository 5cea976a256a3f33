// --soft: the moments over the penumbra's disc, from a few taps that each pixel
// turns. Each is looked up at the level of its own part of the disc, so that
// they leave nothing out between them, and turning them costs little noise.
// needs: Receiver, Disc, POISSON_RADIUS, Merge, POISSON_TAPS, poisson_tap,
//     moments_at_level, merge_about, merge_add, merge_end, penumbra_disc,
//     moments_of
// offers: moments_at

vec2 disc_mean(Receiver receiver, Disc disc)
{
    float level = log2(max(disc.texels * POISSON_RADIUS, 1.0));
    Merge merge;
    for (int i = 0; i < POISSON_TAPS; i++) {
        vec2 uv = receiver.uv + disc.uv_step * poisson_tap(i);
        vec2 tap = moments_at_level(uv, receiver.layer, level);
        if (i == 0) {
            merge = merge_about(tap);
        }
        merge_add(merge, 1.0, tap);
    }
    return merge_end(merge, float(POISSON_TAPS));
}

// Where all is lit: the moments of the receiver itself.
vec2 moments_at(Receiver receiver)
{
    Disc disc = penumbra_disc(receiver);
    return disc.lit ? moments_of(receiver.depth, 0.0)
                    : disc_mean(receiver, disc);
}
