#!/bin/sh
# Makes a step's two committed pictures: figure.png, what the program draws,
# and error.png, its visibility minus footprint truth.
# usage: figures.sh BUILD PROGRAM
set -eu
export LC_ALL=C # numbers have points
build=$1
program=$2
dump=out/figures/$program
mkdir -p "$dump"
"$build/$program" --size 640x360 --output "$program/figure.png" >"$dump/log"
"$build/$program" --size 640x360 --dump "$dump" >"$dump/log"
"$build/oracle" errors "$dump" "write=$dump" >"$dump/errors.csv"
rmse=$(awk -F, '$1 == "footprint" { printf "%.4f", $5 }' "$dump/errors.csv")
gnuplot -e "input='$dump/error.footprint.bin'; width=640; height=360;
    name='$program: visibility against footprint truth, RMSE $rmse';
    output='$program/error.png'" tests/report/error_picture.gp
echo "$program/figure.png $program/error.png: RMSE $rmse"

# panel NAME OPTION...: what $drawn draws, one part of a technique's picture.
panel() {
    name=$1
    shift
    "$build/$drawn" --size 640x360 --output "$dump/$name.png" "$@" >"$dump/log"
}

# join FILE PANEL...: the panels side by side, two in a row, at half their size.
join() {
    file=$1
    shift
    panels=
    for name; do panels="$panels $dump/$name.png"; done
    # shellcheck disable=SC2086 # a list of words
    montage $panels -tile 2x -resize 48% -geometry +2+2 -depth 8 -strip "$file"
    echo "$file"
}

# technique NAME PANEL...: the picture of a technique of this step.
technique() {
    name=$1
    shift
    join "$program/techniques/$name/picture.png" "$@"
}

drawn=$program
case $program in
step1_shadowmap)
    panel acne --bias 0 --slope-bias 0
    panel panning --scene thin --bias 0.02 --slope-bias 0
    join "$program/bias.png" acne panning
    panel spot --scene stage
    panel layers --scene room --show layer
    technique lights spot layers
    panel one --scene avenue --map-size 256
    panel four --scene avenue --map-size 256 --splits 4
    technique splits one four
    ;;
step2_pcf)
    panel grid --map-size 128 --kernel 3
    panel bilinear --map-size 128 --kernel 3 --bilinear
    technique bilinear grid bilinear
    panel grid --map-size 256 --kernel 15
    panel disc --map-size 256 --kernel 15 --pattern poisson
    technique poisson grid disc
    panel narrow --scene fence --map-size 2048 --kernel 3
    panel adaptive --scene fence --map-size 2048 --kernel 31 --adaptive
    technique adaptive narrow adaptive
    ;;
step3_moments)
    central=$program/techniques/central/picture.png
    "$build/fuzz" --count 20000 --csv >"$dump/fuzz.csv"
    gnuplot -e "kind='png'; input='$dump/fuzz.csv'; output='$central'" \
        tests/stability/fuzz.gp
    echo "$central"
    drawn=step5_chebyshev
    bare='--moments raw --map-size 256 --radius 0 --min-variance 0'
    # shellcheck disable=SC2086 # a list of words
    {
        panel flat --scene teapot:elevation=20 $bare
        panel slope --scene teapot:elevation=20 $bare --slope-term
    }
    technique slope flat slope
    panel linear --scene stage --show mean
    panel projected --scene stage --show mean --depth projected
    technique projected linear projected
    panel texels --scene fence --map-size 128 --radius 1
    panel samples --scene fence --map-size 128 --radius 1 --msaa 4
    technique msaa texels samples
    panel raw --scene edge:gap=0.03 --format rg16f --moments raw
    panel half --scene edge:gap=0.03 --format rg16f
    technique half raw half
    ;;
step4_blur)
    drawn=step5_chebyshev
    panel none --blur none
    panel box --radius 24
    panel boxes --radius 24 --blur boxes
    panel gaussian --radius 24 --blur gaussian
    technique kernels none box boxes gaussian
    fence='--scene fence --map-size 2048 --radius 1'
    taps='--mips --anisotropy 16'
    # shellcheck disable=SC2086 # a list of words
    {
        panel plain $fence
        panel mips $fence --mips
        panel explicit $fence $taps
        panel hardware $fence $taps --sampler hardware
    }
    technique mips plain mips explicit hardware
    panel fragments --radius 31 --blur-by fragments
    panel sat --radius 31 --sat
    technique sat fragments sat
    ;;
step5_chebyshev)
    panel nothing --scene edge:gap=0.03 --min-variance 0
    panel least --scene edge:gap=0.03
    panel constant --scene avenue --min-variance 1e-3
    panel proven --scene avenue
    technique guard nothing least constant proven
    panel fixed --scene teapot:elevation=25 --radius 8
    panel soft --scene teapot:elevation=25 --soft --light-size 0.2
    panel bound --scene bleed:r=4 --soft
    panel hybrid --scene bleed:r=4 --soft --hybrid
    technique soft fixed soft bound hybrid
    panel forward
    panel deferred --deferred
    technique deferred forward deferred
    panel fixed --map-size 256 --radius 7 --sat
    panel adaptive --map-size 256 --radius 7 --sat --sat-width adaptive
    technique sat_width fixed adaptive
    reduced='--scene bleed --radius 30 --bleed-reduction 0.3'
    # shellcheck disable=SC2086 # a list of words
    {
        panel linear $reduced
        panel smooth $reduced --reduction smooth
    }
    technique smooth linear smooth
    panel unbiased --scene edge:gap=0.03
    panel biased --scene edge:gap=0.03 --variance-bias 1e-3
    technique variance_bias unbiased biased
    ;;
esac
