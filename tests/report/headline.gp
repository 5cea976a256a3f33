# Time against width, and error against time, on the default scene.
# gnuplot -e "folder='out/figures/report'; output='x.png'"
set terminal pngcairo size 880, 360 font 'sans,11' noenhanced
set output output
pcf = folder . '/PCF.dat'
vsm = folder . '/VSM.dat'
hard = folder . '/hard.dat'
set border 3
set tics nomirror
set grid lc rgb '#c0c0c0' lw 0.5
set logscale xy
set key Left reverse at graph 0.3, graph 0.98
set multiplot layout 1, 2
set xlabel 'width of the filter, texels'
set ylabel 'time of a frame, ms'
set xrange [2.5:38]
set xtics (3, 7, 15, 31)
set ytics (5, 10, 20, 50, 100, 200, 500, 1000, 2000)
set autoscale yfix
set offsets 0, 0, graph 0.1, graph 0.1
plot pcf using 1:2:3:4 with yerrorlines pt 7 lc rgb '#e07b00' title 'PCF', \
    vsm using 1:2:3:4 with yerrorlines pt 9 lc rgb '#2f7ed8' title 'VSM'
unset key
set xlabel 'time of a frame, ms'
set ylabel 'RMSE of the visibility, footprint truth'
set autoscale xfix
set xrange [*:*]
set offsets graph 0.1, graph 0.15, graph 0.1, graph 0.1
set xtics (5, 10, 20, 50, 100, 200, 500, 1000, 2000)
set ytics (0.01, 0.015, 0.02, 0.03, 0.05, 0.07)
plot pcf using 2:5 with linespoints pt 7 lc rgb '#e07b00', \
    pcf using 2:5:1 with labels left offset 0.7, 0.5 tc rgb '#e07b00', \
    vsm using 2:5 with linespoints pt 9 lc rgb '#2f7ed8', \
    vsm using 2:5:1 with labels left offset 0.7, 0.5 tc rgb '#2f7ed8', \
    hard using 2:5 with points pt 5 lc rgb '#888888', \
    hard using 2:5:("hard") with labels left offset 0.7, -0.5 tc rgb '#888888'
unset multiplot
