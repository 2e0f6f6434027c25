# A picture of a sweep: its variants as points. The script that loads this one has set
#     picture                    name of the data file without .dat, and of the picture
#     heading                    the title
#     x_axis, y_axis             names of the axes
#     number[1:4]                how many variants miss a limit, keep all, are the front, the best
#     format                     svg, pdf, png or txt
# and may have set `output`, to draw to another file than PICTURE.FORMAT.

if (exists("output")) { output_file = output } else { output_file = picture.'.'.format }
box_width = 640.0; box_height = 460.0
left = 110.0; right = 190.0; top = 50.0; below = 64.0
text_columns = 79; text_rows = 34

load 'style.gp'

data = picture.'.dat'
array mark[4]  = [2, 6, 7, 3]
array colour[4] = ['#8a94a0', '#56606b', '#0072b2', '#d55e00']
# Marks grow where there are few.
few = number[1] + number[2] + number[3] + number[4] < 200
array big[4]   = [few ? 0.6 : 0.4, few ? 0.6 : 0.4, few ? 0.8 : 0.7, 2.0]
array legend[4] = ['miss a limit', 'keep all limits', 'Pareto front', 'best']
# Which of the four blocks are there, and which block of the data each is.
array place[4]
blocks = ''
do for [i=1:4] { if (number[i] > 0) { place[i] = words(blocks); blocks = blocks.' '.i } }

set title heading noenhanced textcolor rgb ink
set xlabel x_axis noenhanced textcolor rgb ink
set ylabel y_axis noenhanced textcolor rgb ink
set key noenhanced textcolor rgb ink outside right top Left reverse samplen 1.5 spacing 1.2
set offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04

if (blocks eq '') {
    set xrange [0:1]; set yrange [0:1]
    plot NaN title 'no variant could be measured'
} else {
    plot for [block in blocks] i = block + 0, data index place[i] using 1:2 \
        with points pointtype mark[i] pointsize big[i] linecolor rgb colour[i] title legend[i]
}
unset output
