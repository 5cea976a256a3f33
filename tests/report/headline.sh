#!/bin/sh
# Makes the root README's diagram, tests/report/headline.png: time and error of
# PCF and VSM on the default scene, measured as in the full report. Prints the
# numbers of its table: map and blur, shading, RMSE by footprint and ray.
# usage: headline.sh BUILD
set -eu
export LC_ALL=C # numbers have points
out=out/figures/report
mkdir -p "$out"
VSM_BUILD=$1 REPORT=headline REPORT_OUT=$out perl tests/report/report.pl \
    >"$out/report.txt"

# points NAME: width, frame and its quartiles, error, of one technique. No
# field of these rows holds a comma.
points() {
    awk -F, -v name="$1" '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        $at["scene"] == "teapot" && $at["technique"] == name {
            print $at["width"], $at["total_ms"], $at["total_q1"],
                $at["total_q3"], $at["footprint_rmse"]
        }' "$out/results.csv" | sort -n
}
for technique in hard PCF VSM; do
    points "$technique" >"$out/$technique.dat"
done
awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    {
        printf "%-16s %6.1f %6.1f %6.3f %6.3f\n", $at["label"],
            $at["map_ms"] + $at["blur_ms"], $at["shading_ms"],
            $at["footprint_rmse"], $at["light_rmse"]
    }' "$out/results.csv"
gnuplot -e "folder='$out'; output='tests/report/headline.png'" \
    tests/report/headline.gp
echo tests/report/headline.png
