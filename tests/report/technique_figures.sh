#!/bin/sh
# Makes the committed pictures of the techniques, two panels side by side.
# usage: technique_figures.sh BUILD
set -eu
build=$1
work=out/figures/techniques
mkdir -p "$work"

# panels PICTURE LEFT RIGHT: each side is a program and its options, a line.
panels() {
    # shellcheck disable=SC2086 # the line is split into words on purpose
    $build/$2 --size 480x270 --output "$work/left.png"
    # shellcheck disable=SC2086
    $build/$3 --size 480x270 --output "$work/right.png"
    montage "$work/left.png" "$work/right.png" -tile 2x1 -geometry +2+2 \
        -strip "$1"
    echo "$1"
}

p=step2_pcf
panels $p/technique_bias.png "step1_shadowmap --bias 0 --slope-bias 0" \
    "step1_shadowmap --scene thin --bias 0.02 --slope-bias 0"
panels $p/technique_bilinear.png "$p --map-size 128 --kernel 3" \
    "$p --map-size 128 --kernel 3 --bilinear"
panels $p/technique_poisson.png "$p --map-size 256 --kernel 15" \
    "$p --map-size 256 --kernel 15 --pattern poisson"
panels $p/technique_adaptive.png "$p --scene fence --map-size 2048 --kernel 3" \
    "$p --scene fence --map-size 2048 --kernel 31 --adaptive"
