#!/bin/sh
# What a frame of each step costs and, where there is an oracle, how wrong its
# visibility is: for `make` and `make table`. usage: table.sh BUILD [SIZE]
set -eu
build=$1
size=${2:-640x360}
frames=31
echo
echo "Milliseconds, medians of $frames frames of $size: compare them with each"
echo 'other only.'
echo 'Wrong: RMSE of the visibility, in [0, 1], against exact rays, averaged over the'
echo "filter's footprint, or one ray to the light."
printf '\n%-17s%11s%9s%9s%18s%9s\n' step 'map + blur' shading frame \
    'wrong: footprint' 'one ray'
for program in "$build"/step[1-5]_*; do
    dump=out/table/${program##*/}
    mkdir -p "$dump"
    "$program" --size "$size" --bench $frames --redraw \
        --output "$dump/picture.png" >"$dump/times.csv"
    : >"$dump/errors.csv"
    if [ -x "$build/oracle" ]; then
        "$program" --size "$size" --dump "$dump" --output "$dump/picture.png"
        "$build/oracle" errors "$dump" >"$dump/errors.csv"
    fi
    awk -F, -v step="${program##*/}" '
        FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        FILENAME ~ /times/ { ms[$1] = $at["median_ms"]; next }
        { rmse[$1] = sprintf("%.3f", $at["rmse"]) }
        END {
            printf "%-17s%11.1f%9.1f%9.1f%18s%9s\n", step,
                ms["total"] - ms["shading"], ms["shading"], ms["total"],
                "footprint" in rmse ? rmse["footprint"] : "-",
                "hard" in rmse ? rmse["hard"] : "-"
        }' "$dump/times.csv" "$dump/errors.csv"
done
[ -x "$build/oracle" ] ||
    printf '\nmake table: how wrong, too (builds the oracle first)\n'
