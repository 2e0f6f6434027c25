# The time of a cut over its points, for doc/performance.md. `make bench` has set
#     folder                  where the data are: cuts.dat, points and seconds of four kinds of cut
#     format, output_file     of the picture

box_width = 520; box_height = 330
left = 84.0; right = 40.0; top = 48.0; below = 66.0
text_columns = 79; text_rows = 30
load 'style.gp'

set logscale xy
set xlabel 'points of the cut' textcolor rgb ink
set ylabel 'milliseconds' textcolor rgb ink
set format x '%.0f'
set format y '%g'
set title 'Time of a cut of the nose, one core, all facts and the proof by a second way' textcolor rgb ink
set key top left textcolor rgb ink
data = folder.'/cuts.dat'
array kind[4] = ['station', 'waterline', 'buttock', 'oblique']
plot for [i=1:4] data using 1:(1000*column(i+1)) with linespoints linetype i pointtype 7 \
     pointsize 0.5 title kind[i]
unset output
