# What the variance loses against its condition number, and the bound.
# gnuplot -e "input='fuzz.csv'; output='fuzz.svg'; kind='svg'" fuzz.gp
if (kind eq 'svg') set terminal svg size 1100, 620 font 'sans,12' background 'white'; \
else set terminal pngcairo size 1100, 620 font 'sans,12'
set output output
set datafile separator ','
set logscale x 2
set xrange [1:2**40]
set yrange [0:45]
set format x '2^{%L}'
set xlabel 'condition number M2 / variance'
set key off
set multiplot layout 2, 3 title "Bits of the variance lost (24 in a float), and the bound (orange)"
do for [moments in 'raw central'] {
    do for [format in 'fp32 fp16 fp16-truncated'] {
        name = format.'-'.moments
        set title name
        set ylabel 'bits lost'
        plot input using (strcol(1) eq name ? $3 : NaN):5 with dots lc rgb '#e69f00', \
            '' using (strcol(1) eq name ? $3 : NaN):4 with dots lc rgb '#0072b2', \
            24 with lines lc rgb 'gray' dt 2
    }
}
unset multiplot
