# The signed error of the visibility as a picture with a scale.
# gnuplot -e "input='error.bin'; width=640; height=360; name='...'; output='x.png'"
set terminal pngcairo size width + 110, height + 40 font 'sans,11' noenhanced
set output output
set title name offset 0, -0.6
set palette defined (-1 '#08306b', -0.25 '#6baed6', 0 '#f7f7f7', \
    0.25 '#fb6a4a', 1 '#67000d')
set cbrange [-1:1]
set cblabel 'visibility minus truth' offset 1, 0
set xrange [-0.5:width - 0.5]
set yrange [height - 0.5:-0.5]
unset xtics
unset ytics
set lmargin at screen 6.0 / (width + 110)
set rmargin at screen (width + 6.0) / (width + 110)
set bmargin at screen 6.0 / (height + 40)
set tmargin at screen (height + 6.0) / (height + 40)
unset key
plot input binary array=(width, height) format='%float' with image
