# A body in space, as a net of its sections with what is hidden left out. The script that loads this
# one has set
#     picture                        name of the data file without .dat, and of the picture
#     heading, view                  the title
#     layers                         the data sets: each a grid of STA, BL and WL
#     format                         svg, pdf, png or txt
# and may have set `output`, to draw to another file than PICTURE.FORMAT, and `turn` and `tilt`, the
# direction it is seen from in degrees, with -e "turn=60; tilt=80": 0 and 0 is from above, the
# stations to the right.

if (exists("output")) { output_file = output } else { output_file = picture.'.'.format }
if (!exists("turn")) { turn = 322.0 }
if (!exists("tilt")) { tilt = 64.0 }
data = picture.'.dat'

# To the right, upwards and away from the eye, turned about WL, then tilted. (A map, as gnuplot calls
# a view straight along the third axis, is seen from below it.)
set angles degrees
right_of(x, y)   = x*cos(turn) + y*sin(turn)
up_of(x, y, z)   = (y*cos(turn) - x*sin(turn))*cos(tilt) + z*sin(tilt)
away_of(x, y, z) = (y*cos(turn) - x*sin(turn))*sin(tilt) - z*cos(tilt)
stats data using (right_of($1, $2)):(up_of($1, $2, $3)) nooutput name 'seen'

# The box has the shape of what is seen.
width = seen_max_x - seen_min_x
height = seen_max_y - seen_min_y
scale = 1000/width < 800/height ? 1000/width : 800/height
box_width = width*scale
box_height = height*scale
left = 40.0; top = 90.0; below = 40.0; right = 40.0
if (left + box_width + right < 560) { left = 280 - box_width/2; right = left }
text_columns = 131
text_rows = floor(115*height/width/2) + 8
load 'style.gp'
load 'strokes.gp'
set angles degrees

unset border; unset tics; unset key; unset grid; unset colorbox
set view map
set xrange [seen_min_x:seen_max_x]
set yrange [seen_min_y:seen_max_y]
set label 1 heading at screen 0.5, 1 - 28.0/paper_height center font fonts[3] noenhanced textcolor rgb ink
set label 2 view at screen 0.5, 1 - 54.0/paper_height center noenhanced textcolor rgb ink
if (format eq 'txt') {
    set hidden3d back offset 0
    splot for [i=1:layers] data index i-1 every 4:4 using (right_of($1, $2)):(up_of($1, $2, $3)):(away_of($1, $2, $3)) \
              with lines linestyle stroke('skin')
} else {
    set pm3d depthorder border linecolor rgb ink linewidth 0.5
    set palette defined (0 '#eef3f7', 1 '#eef3f7')
    splot for [i=1:layers] data index i-1 using (right_of($1, $2)):(up_of($1, $2, $3)):(away_of($1, $2, $3)) \
              with pm3d
}
unset output
