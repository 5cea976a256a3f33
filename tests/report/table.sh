#!/bin/sh
# What a frame of each step costs and, where there is an oracle, how wrong its
# visibility is: for `make` and `make table`. usage: table.sh BUILD [SIZE]
set -eu
export LC_ALL=C # numbers have points
build=$1
size=${2:-640x360}
frames=31
wrong=
[ ! -x "$build/oracle" ] || wrong=yes
echo
echo "Milliseconds, medians of $frames frames of $size: compare them with each"
echo 'other only.'
[ -z "$wrong" ] || {
    echo 'Wrong: RMSE of the visibility, in [0, 1], against exact rays,' \
        'averaged over the'
    echo "filter's footprint, or one ray to the light."
}
printf '\n%-17s%11s%9s%9s' step 'map + blur' shading frame
[ -z "$wrong" ] || printf '%18s%9s' 'wrong: footprint' 'one ray'
echo
for program in "$build"/step[1-5]_*; do
    dump=out/table/${program##*/}
    mkdir -p "$dump"
    "$program" --size "$size" --bench $frames --redraw >"$dump/times.csv"
    : >"$dump/errors.csv"
    [ -z "$wrong" ] || {
        "$program" --size "$size" --dump "$dump" >"$dump/log"
        "$build/oracle" errors "$dump" >"$dump/errors.csv"
    }
    awk -F, -v step="${program##*/}" '
        FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        FILENAME ~ /times/ { ms[$1] = $at["median_ms"]; next }
        { rmse[$1] = $at["rmse"]; wrong = 1 }
        END {
            printf "%-17s%11.1f%9.1f%9.1f", step, ms["total"] - ms["shading"],
                ms["shading"], ms["total"]
            if (wrong) printf "%18.3f%9.3f", rmse["footprint"], rmse["hard"]
            print ""
        }' "$dump/times.csv" "$dump/errors.csv"
done
[ -n "$wrong" ] ||
    printf '\nmake table: how wrong, too (builds the oracle first)\n'
