# The lines and words of a picture of a body. Loaded after style.gp by the script of a kind of
# picture.

# The number of the line style of a style, and whether it is drawn as points.
stroke(s) = s eq 'grid'      ?  1 : s eq 'centre'  ?  2 : s eq 'line'    ?  3 : s eq 'section' ? 4 : \
            s eq 'buttock'   ?  5 : s eq 'waterline' ? 6 : s eq 'tooth'  ?  7 : s eq 'ridge'   ? 8 : \
            s eq 'joint'     ?  9 : s eq 'outline' ? 10 : s eq 'mirror'  ? 11 : s eq 'inside'  ? 12 : \
            s eq 'point'     ? 13 : s eq 'curve'   ? 14 : s eq 'centroid' ? 15 : 16
is_mark(s) = s eq 'joint' || s eq 'point'

blue = '#0072b2'; vermilion = '#d55e00'; green = '#009e73'; sky = '#56b4e9'
dot = format eq 'txt' ? 15 : 7     # the letter O, a filled circle
ring = format eq 'txt' ? 15 : 6
set style line  1 linewidth 0.5 linecolor rgb pale
set style line  2 linewidth 0.7 linecolor rgb '#888888' dashtype (16,4,3,4)
set style line  3 linewidth 1.6 linecolor rgb ink
set style line  4 linewidth 1.2 linecolor rgb blue
set style line  5 linewidth 1.2 linecolor rgb vermilion
set style line  6 linewidth 1.2 linecolor rgb green
set style line  7 linewidth 0.5 linecolor rgb sky
set style line  8 linewidth 1.0 linecolor rgb blue
set style line  9 pointtype ring pointsize 0.6 linewidth 1.2 linecolor rgb vermilion
set style line 10 linewidth 1.8 linecolor rgb blue
set style line 11 linewidth 1.0 linecolor rgb '#9fb6c3' dashtype (10,4)
set style line 12 linewidth 1.0 linecolor rgb vermilion
set style line 13 pointtype dot pointsize 0.45 linewidth 1.0 linecolor rgb ink
set style line 14 linewidth 1.8 linecolor rgb blue
set style line 15 linewidth 1.0 linecolor rgb vermilion dashtype (10,4)
set style line 16 linewidth 0.6 linecolor rgb ink

# Words: small, plain and titles; in a white box, so that lines do not run through them.
points = format eq 'svg' ? 13 : 10
array fonts[3]
fonts[1] = sprintf(',%.1f', 0.78*points)
fonts[2] = sprintf(',%.1f', 1.0*points)
fonts[3] = sprintf(',%.1f', 1.3*points)
set style textbox opaque noborder margins 0.6,0.4 fillcolor rgb 'white'
stands(side, size, wanted_side, wanted_size) = side == wanted_side && size == wanted_size
