# Colours, lines, grid and output of every picture of LOFT. Loaded by the script of a kind of picture,
# which has set
#     format                  svg, pdf, png or txt
#     output_file             name of the picture
#     box_width, box_height   the box between the axes, dots of 1/96 inch
#     left, right, top, below the margins around it, dots
#     text_columns, text_rows the picture as text, characters

reset
set encoding utf8

# Seven colours that colour-blind eyes tell apart (Okabe and Ito, 2008); every second line is broken,
# so that of two lines on the same place both are seen; later lines are dotted.
array colour[7] = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000']
do for [i=1:28] {
    if (i % 2 == 1) { set linetype i linewidth 1.8 linecolor rgb colour[(i-1)%7+1] dashtype solid }
    if (i % 2 == 0) { set linetype i linewidth 1.8 linecolor rgb colour[(i-1)%7+1] dashtype (14,5) }
    if (i > 14)     { set linetype i linewidth 1.8 linecolor rgb colour[(i-1)%7+1] dashtype (4,4) }
}
set linetype cycle 28

ink  = '#333333'
pale = '#d9d9d9'
set border 3 linewidth 0.8 linecolor rgb ink
set grid xtics ytics linetype 1 linewidth 0.5 linecolor rgb pale
set tics nomirror out scale 0.6 textcolor rgb ink
set format '%.10g'

# The paper: margins and box, in dots.
paper_width  = left + box_width + right
paper_height = top + box_height + below
set lmargin at screen left/paper_width
set rmargin at screen (left + box_width)/paper_width
set bmargin at screen below/paper_height
set tmargin at screen (below + box_height)/paper_height

if (format eq 'svg') {
    set terminal svg noenhanced size paper_width,paper_height dynamic \
        font 'Helvetica,Arial,sans-serif,13' background rgb 'white'
}
if (format eq 'pdf') {
    set terminal pdfcairo noenhanced size paper_width/96.0,paper_height/96.0 \
        font 'Helvetica,10' fontscale 0.75 linewidth 1.3
}
if (format eq 'png') {
    set terminal pngcairo noenhanced size 2*paper_width,2*paper_height \
        font 'Helvetica,10' fontscale 2.0 linewidth 2.0 pointscale 2.0 background rgb 'white'
}
if (format eq 'txt') {
    set terminal dumb noenhanced mono size text_columns,text_rows
    set lmargin -1; set rmargin -1; set tmargin -1; set bmargin -1
    unset grid
}
set output output_file
