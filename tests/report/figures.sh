#!/bin/sh
# Makes a step's two committed pictures: figure.png, what the program draws,
# and error.png, its visibility minus footprint truth.
# usage: figures.sh BUILD PROGRAM
set -eu
build=$1
program=$2
dump=out/figures/$program
mkdir -p "$dump"
"$build/$program" --size 640x360 --output "$program/figure.png"
"$build/$program" --size 640x360 --dump "$dump" --output "$dump/picture.png"
"$build/oracle" errors "$dump" "write=$dump" >"$dump/errors.csv"
rmse=$(awk -F, '$1 == "footprint" { printf "%.4f", $5 }' "$dump/errors.csv")
gnuplot -e "input='$dump/error.footprint.bin'; width=640; height=360;
    name='$program: visibility against footprint truth, RMSE $rmse';
    output='$program/error.png'" tests/report/error_picture.gp
echo "$program/figure.png $program/error.png"
