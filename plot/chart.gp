# A drawing in a box with axes: a cut in its true shape, an area curve. The script that loads this one
# has set
#     picture                        name of the data file without .dat, and of the picture
#     heading, view, note            the title; the note may be nothing
#     x_axis, y_axis                 names of the axes with the unit
#     x_low, x_high, y_low, y_high   what is shown, deck units
#     x_dot, y_dot                   deck units a dot of 1/96 inch, to the right and upwards
#     layers, style[1:layers]        the data sets, and the style of each
#     words, word[1:words]           what is written; its places are the last data set
#     format                         svg, pdf, png or txt
# and may have set `output`, to draw to another file than PICTURE.FORMAT.

if (exists("output")) { output_file = output } else { output_file = picture.'.'.format }
box_width  = (x_high - x_low)/x_dot
box_height = (y_high - y_low)/y_dot
left = 84.0; top = 88.0; below = 72.0; right = 40.0
if (left + box_width + right < 560) { right = 560 - left - box_width }

# As text: two characters side by side are as wide as one is high.
text_columns = 79
text_rows = floor(66*box_height/box_width/2) + 10
if (text_rows > 100) { text_rows = 100 }

load 'style.gp'
load 'strokes.gp'

set xrange [x_low:x_high]
set yrange [y_low:y_high]
set xlabel x_axis textcolor rgb ink
set ylabel y_axis textcolor rgb ink
title_text = heading."\n".view
if (note ne '') { title_text = title_text."\n".note }
if (format eq 'txt') { title_text = title_text."\n"."upwards: ".y_axis; unset ylabel }
set title title_text noenhanced textcolor rgb ink
unset key

# A layer is drawn twice, as lines and as points; once of them out of sight.
away = y_low - (y_high - y_low)
data = picture.'.dat'
plot for [i=1:layers] data index i-1 using 1:(is_mark(style[i]) ? away : $2) with lines \
         linestyle stroke(style[i]), \
     for [i=1:layers] data index i-1 using 1:(is_mark(style[i]) ? $2 : away) with points \
         linestyle stroke(style[i]), \
     for [s=0:(words > 0 ? 2 : -1)] data index layers using 1:2:(stands($4, $5, -1, s) ? word[int($3)] : "") \
         with labels right font fonts[s+1] textcolor rgb ink noenhanced, \
     for [s=0:(words > 0 ? 2 : -1)] data index layers using 1:2:(stands($4, $5, 0, s) ? word[int($3)] : "") \
         with labels center font fonts[s+1] textcolor rgb ink noenhanced, \
     for [s=0:(words > 0 ? 2 : -1)] data index layers using 1:2:(stands($4, $5, 1, s) ? word[int($3)] : "") \
         with labels left font fonts[s+1] textcolor rgb ink noenhanced
unset output
