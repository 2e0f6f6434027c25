# A drawing on a blank sheet to one scale, with words on it: a lines plan, curvature combs. LOFT has
# placed everything; here it is only drawn. The script that loads this one has set
#     picture                        name of the data file without .dat, and of the picture
#     x_low, x_high, y_low, y_high   the sheet, deck units
#     x_dot                          deck units a dot of 1/96 inch
#     layers, style[1:layers]        the data sets, and the style of each
#     words, word[1:words]           what is written; its places are the last data set
#     format                         svg, pdf, png or txt
# and may have set `output`, to draw to another file than PICTURE.FORMAT.

if (exists("output")) { output_file = output } else { output_file = picture.'.'.format }
box_width  = (x_high - x_low)/x_dot
box_height = (y_high - y_low)/x_dot
left = 0.0; right = 0.0; top = 0.0; below = 0.0
text_columns = 131
text_rows = floor(131*box_height/box_width/2.0) + 1
load 'style.gp'
load 'strokes.gp'

unset border; unset tics; unset key; unset grid
set xrange [x_low:x_high]
set yrange [y_low:y_high]

data = picture.'.dat'
plot for [i=1:layers] data index i-1 using 1:(is_mark(style[i]) ? NaN : $2) with lines \
         linestyle stroke(style[i]), \
     for [i=1:layers] data index i-1 using 1:(is_mark(style[i]) ? $2 : NaN) with points \
         linestyle stroke(style[i]), \
     for [s=0:(words > 0 ? 2 : -1)] data index layers using (stands($4, $5, -1, s) ? $1 : NaN):2:(word[int($3)]) \
         with labels right boxed font fonts[s+1] textcolor rgb ink noenhanced, \
     for [s=0:(words > 0 ? 2 : -1)] data index layers using (stands($4, $5, 0, s) ? $1 : NaN):2:(word[int($3)]) \
         with labels center boxed font fonts[s+1] textcolor rgb ink noenhanced, \
     for [s=0:(words > 0 ? 2 : -1)] data index layers using (stands($4, $5, 1, s) ? $1 : NaN):2:(word[int($3)]) \
         with labels left boxed font fonts[s+1] textcolor rgb ink noenhanced
unset output
