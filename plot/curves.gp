# A picture of curves: lines, the points 1, 2 and 3 that fix each conic, and the tangents at 1 and 3.
# The script that loads this one has set
#     picture                    name of the data file without .dat, and of the picture
#     heading, view              the title
#     x_axis, y_axis             names of the axes with the unit
#     x_low, x_high, y_low, y_high   what is shown, deck units
#     curves, name[1:curves]     how many curves, and what they are called
#     format                     svg, pdf, png or txt
# and may have set `output`, to draw to another file than PICTURE.FORMAT.

if (exists("output")) { output_file = output } else { output_file = picture.'.'.format }

# The box has the shape of what it shows, so that a unit is as long upwards as to the right.
shape = (y_high - y_low)/(x_high - x_low)
box_width  = shape <= 1 ? 660.0 : floor(660/shape)
box_height = shape <= 1 ? floor(660*shape) : 660.0

# The legend stands to the right: columns of lines that fit beside the box. Of more than 120 curves
# only the lines are drawn.
longest_name = 34
short(text) = strlen(text) > longest_name ? text[1:longest_name - 3].'...' : text
widest = 0
do for [i=1:curves] { if (strlen(short(name[i])) > widest) { widest = strlen(short(name[i])) } }
most_lines = 30
legends = curves <= 4*most_lines ? curves : 0
columns = (legends + most_lines - 1)/most_lines
column_width = 45 + 8*widest

# Steps of the axes, 1, 2 or 5 times a power of ten: at most as many as have room for their numbers.
power(x) = 10.0**floor(log10(x))
nice(x) = x <= power(x) ? power(x) : x <= 2*power(x) ? 2*power(x) : x <= 5*power(x) ? 5*power(x) : 10*power(x)
number(x, step) = sprintf('%.10g', floor(x/step)*step)
letters_in_box = format eq 'txt' ? 66 : box_width/8
x_letters = 0
do for [i=0:10] {
    length = strlen(number(x_low + i*(x_high - x_low)/10, nice((x_high - x_low)/10)))
    if (length > x_letters) { x_letters = length }
}
most_steps = floor(letters_in_box/(x_letters + 2))
x_step = nice((x_high - x_low)/(most_steps < 10 ? (most_steps > 1 ? most_steps : 1) : 10))
y_steps = box_height < 400 ? 8 : 10
y_step = nice((y_high - y_low)/y_steps)
y_letters = 0
do for [i=0:10] {
    length = strlen(number(y_low + i*(y_high - y_low)/10, y_step))
    if (length > y_letters) { y_letters = length }
}

left = 52.0 + 8*y_letters; top = 70.0; below = 72.0
right = 30.0 + columns*column_width
beside = 4.0*strlen(heading) - box_width/2      # the title may be wider than the box
if (left < beside) { left = beside }
if (right < beside) { right = beside }
lines = legends < most_lines ? legends : most_lines
if (top + box_height + below < 60 + 20*lines) { below = 60 + 20*lines - top - box_height }

# As text: two characters side by side are as wide as one is high.
text_columns = 79
text_rows = (shape < 1.8 ? floor(33*shape) : 60) + 10 + legends

load 'style.gp'

set size ratio -1
set xrange [x_low:x_high]
set yrange [y_low:y_high]
set xtics x_step
set ytics y_step
set xlabel x_axis textcolor rgb ink
set ylabel y_axis textcolor rgb ink
title_text = heading."\n".view
if (format eq 'txt') { title_text = title_text."\n"."upwards: ".y_axis; unset ylabel }
set title title_text noenhanced textcolor rgb ink
set key noenhanced textcolor rgb ink samplen 2.5 spacing 1.2 Left reverse
if (legends == 0) { unset key } else {
    if (format eq 'txt') { set key below center vertical maxcolumns 2 } else {
        set key at screen (left + box_width + 24.0)/paper_width, screen (below + box_height*1.0)/paper_height \
            left top vertical maxrows most_lines
    }
}

data = picture.'.dat'
arcs = 0; points = 1; tangents = 2; figures = 3
dot = format eq 'txt' ? 15 : 7     # the letter O, a filled circle

if (legends > 0) {
    plot data index tangents using 1:2:3:4:5 with vectors nohead linewidth 0.9 dashtype solid linecolor variable notitle, \
         for [i=1:curves] data index arcs every :::(i-1)::(i-1) using 1:2 with lines linetype i title short(name[i]), \
         data index points using 1:2:3 with points pointtype dot pointsize 0.45 linecolor variable notitle, \
         data index figures using 1:2:(sprintf('%d', $3)) with labels textcolor rgb ink noenhanced notitle
} else {
    plot data index arcs using 1:2:(column(-1) + 1) with lines linewidth 1 linecolor variable notitle
}
unset output
