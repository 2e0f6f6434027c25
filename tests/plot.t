#!/bin/sh
# loft plot on decks of 1970: pictures, data and scripts, what a careless user does, hostile names.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
loft=${LOFT:?} deck=$PWD/cards/sae700202.crd plot=$PWD/plot
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
unset CDPATH
LOFT_PLOT=$plot && export LOFT_PLOT

# Runs loft plot, keeps output, messages and status.
plot() {
    "$loft" plot "$@" > "$work/out" 2> "$work/err" < /dev/null
    status=$?
}
# What went on in the last run.
seen() { echo "status $status"; cat "$work/out" "$work/err"; }
# True where exactly these files are in a folder: holds FOLDER NAMES...
holds() {
    folder=$1; shift
    [ "$(ls -A "$folder" | LC_ALL=C sort | tr '\n' ' ')" = "$(echo "$@" | tr ' ' '\n' | LC_ALL=C sort | tr '\n' ' ')" ]
}
texts='curves.gp style.gp side.dat side.gp plan.dat plan.gp sections.dat sections.gp'

# --- without gnuplot ----------------------------------------------------------------------------

mkdir tools failing silent
ln -s "$(command -v sh)" tools/sh
printf '#!/bin/sh\nexit 3\n' > failing/gnuplot
printf '#!/bin/sh\nexit 0\n' > silent/gnuplot
chmod +x failing/gnuplot silent/gnuplot

(PATH=$work/tools; plot "$deck" -o 'no gnu'; echo "$status" > status); status=$(cat status)
[ "$status" = 2 ] && [ ! -s out ] && grep -q '^loft: no gnuplot.*gnuplot-nox' err
ok $? 'without gnuplot: status 2 and the package to install' "$(seen)"
holds 'no gnu' $texts
ok $? 'without gnuplot: data and scripts are whole, nothing else is left' "$(ls -A 'no gnu')"
grep -qF "cd './no gnu' && gnuplot side.gp plan.gp sections.gp" err
ok $? 'without gnuplot: the message says how to draw' "$(seen)"

(PATH=$work/failing:$PATH; plot "$deck" -o failed; echo "$status" > status); status=$(cat status)
[ "$status" = 2 ] && grep -q 'failed/side.svg: gnuplot did not draw it.*3' err && holds failed $texts
ok $? 'where gnuplot fails: status 2, and no picture is left' "$(seen)"
(PATH=$work/silent:$PATH; plot "$deck" -o silent-plots; echo "$status" > status); status=$(cat status)
[ "$status" = 2 ] && holds silent-plots $texts
ok $? 'where gnuplot draws nothing: status 2' "$(seen)"

# --- careless users -----------------------------------------------------------------------------

# The run is refused in one line and makes no folder: refused 'phrase' 'words' ARGUMENTS...
refused() {
    phrase=$1 words=$2; shift 2
    ls -A > before; plot "$@"; ls -A > after
    [ "$status" = 2 ] && [ ! -s out ] && grep -qF -- "$words" err && [ "$(wc -l < err)" = 1 ] &&
        cmp -s before after
    ok $? "$phrase" "$(seen)"
}
: > after; : > before; : > file
refused 'DIR is a file' 'loft: file: ' "$deck" -o file
refused 'DIR is below a file' 'loft: file/x: ' "$deck" -o file/x
refused 'DIR is where there is no folder' 'loft: a/b: ' "$deck" -o a/b
refused 'DIR is -' '-o -' "$deck" -o -
refused 'the deck is missing' 'loft: none.crd: ' none.crd
refused 'the deck is a folder' 'loft: tools: ' tools
refused 'no deck is named' 'deck'
LOFT_PLOT=/no/such
refused 'the scripts are missing' '/no/such' "$deck"
LOFT_PLOT=$plot

printf '* line\nbad\n' > bad.crd
plot bad.crd
[ "$status" = 1 ] && grep -q '^bad.crd:2:' err && [ ! -d bad-plots ]
ok $? 'a deck with nothing to draw: its faults, status 1, no folder' "$(seen)"

# --- pictures -----------------------------------------------------------------------------------

if ! command -v gnuplot > /dev/null; then
    echo '# no gnuplot on this machine: what it draws is not tested'
    finish; exit
fi

plot "$deck"
[ "$status" = 0 ] && [ ! -s err ]
ok $? 'the deck of 1970 is drawn without a word on standard error' "$(seen)"
holds sae700202-plots $texts side.svg plan.svg sections.svg
ok $? 'into a folder named for the deck' "$(ls -A sae700202-plots)"
printf 'sae700202-plots/%s.svg\n' side plan sections | cmp -s - out
ok $? 'standard output has the names of the pictures' "$(seen)"
[ "$(grep -c 'xml' sae700202-plots/side.svg)" -ge 1 ] && tail -n 3 sae700202-plots/side.svg | grep -q '</svg>'
ok $? 'a picture is whole'
for name in 'LCL side' 'NOSE OF APPENDIX B' 'station (STA), inches' 'waterline (WL), inches'; do
    grep -qF "$name" sae700202-plots/side.svg
    ok $? "the side view says: $name"
done
grep -qF 'butt line (BL), inches' sae700202-plots/plan.svg && grep -qF 'MHB plan' sae700202-plots/plan.svg
ok $? 'the plan view shows butt lines'
grep -qF 'butt line (BL), inches' sae700202-plots/sections.svg &&
    grep -qF 'waterline (WL), inches' sae700202-plots/sections.svg
ok $? 'the sections show waterlines over butt lines'

# A unit is as long upwards as to the right: the box of the SVG has the shape of the ranges.
cat > shape.gp <<'END'
load 'side.gp'
print (GPVAL_TERM_YMAX - GPVAL_TERM_YMIN)*(x_high - x_low)/((GPVAL_TERM_XMAX - GPVAL_TERM_XMIN)*(y_high - y_low))
END
ratio=$(cd sae700202-plots && gnuplot ../shape.gp 2>&1)
awk -v r="$ratio" 'BEGIN { if (r < 0) r = -r; exit !(r > .99 && r < 1.01) }'
ok $? 'the axes are to one scale' "$ratio"

# The data by gnuplot's own eyes, against the printed figures: LCL at station 0 is -18.000 (point 2).
awk '/^# curve 3/ { on = 1; next } /^#|^$/ { on = 0 } on && $1 == 50' sae700202-plots/side.dat |
    awk '{ exit !($2 + 24.1 < 1e-9 && $2 + 24.1 > -1e-9) }'
ok $? 'the data of LCL end in the point of the card'

for format in pdf png txt; do
    plot "$deck" -o "as $format" --format $format
    [ "$status" = 0 ] && [ ! -s err ] && [ -s "as $format/sections.$format" ]
    ok $? "drawn as $format" "$(seen)"
done
head -c 5 'as pdf/side.pdf' | grep -q '%PDF'; ok $? 'the PDF is one'
[ "$(head -c 4 'as png/side.png' | tail -c 3)" = PNG ]; ok $? 'the PNG is one'
"$loft" plot "$deck" -o again --format txt > text 2> err
grep -q 'LCL side' text && grep -q 'STA 30 oblique' text && grep -q 'upwards: waterline' text
ok $? 'text goes to standard output too' "$(cat text)"
[ "$(awk 'length > 79 || / $/ || /\f/' text | wc -l)" = 0 ]
ok $? 'in 79 columns, without blanks at the ends'

plot "$deck" -o twice; cp twice/side.svg first.svg; plot "$deck" -o twice
cmp -s first.svg twice/side.svg
ok $? 'drawn again, an SVG is the same byte for byte'
touch -d 1970-02-02 twice/side.svg 2> /dev/null || :
(PATH=$work/failing:$PATH; plot "$deck" -o twice)
cmp -s first.svg twice/side.svg
ok $? 'where gnuplot fails the old picture stays'

mv twice moved && rm moved/*.svg
(cd moved && gnuplot side.gp plan.gp sections.gp && gnuplot -e "format='txt'" side.gp) > out 2> err
[ ! -s err ] && holds moved $texts side.svg plan.svg sections.svg side.txt && cmp -s first.svg moved/side.svg
ok $? 'a folder that was moved draws its pictures by itself' "$(cat err; ls -A moved)"

"$loft" plot - < "$deck" > out 2> err && [ -s loft-plots/side.svg ]
ok $? 'a deck from standard input goes to loft-plots' "$(seen)"
plot "$deck" -o -dash && [ "$status" = 0 ] && [ -s ./-dash/side.svg ]
ok $? 'the name of DIR may begin with a dash' "$(seen)"
mkdir -p elsewhere/target && CDPATH=$work/elsewhere && export CDPATH
plot "$deck" -o target && [ "$status" = 0 ] && [ -s target/side.svg ]
ok $? 'CDPATH leads nobody astray' "$(seen)"
unset CDPATH

# Where the scripts are found: beside an installed program, or where LOFT_PLOT says.
unset LOFT_PLOT
mkdir -p usr/bin usr/share/loft && cp "$loft" usr/bin/loft && cp -r "$plot" usr/share/loft/plot
usr/bin/loft plot "$deck" -o installed > out 2> err && [ -s installed/side.svg ]
ok $? 'an installed program finds its scripts' "$(cat err)"
(PATH=$work/usr/bin:$PATH; cd usr/share && loft plot "$deck" -o "$work/by-path") > out 2> err && [ -s by-path/side.svg ]
ok $? 'also when called by PATH' "$(cat err)"
ln -s usr/bin/loft linked && ./linked plot "$deck" -o by-link > out 2> err && [ -s by-link/side.svg ]
ok $? 'also when called by a link' "$(cat err)"
mkdir -p tree/build/debug && cp "$loft" tree/build/loft && cp "$loft" tree/build/debug/loft && cp -r "$plot" tree/plot
for built in loft debug/loft; do
    "tree/build/$built" plot "$deck" -o in-tree > out 2> err
    [ -s in-tree/side.svg ]
    ok $? "so does build/$built" "$(cat err)"
    rm -rf in-tree
done
mkdir own && sed "s/#0072b2/#123456/" "$plot/style.gp" > own/style.gp && cp "$plot/curves.gp" own
LOFT_PLOT=$work/own && export LOFT_PLOT
plot "$deck" -o owned; grep -q 'rgb( 18,  52,  86)' owned/side.svg
ok $? 'LOFT_PLOT brings the style of the house' "$(cat err)"
LOFT_PLOT=$plot

# --- hard decks ---------------------------------------------------------------------------------

printf -- '-30.    5.      0.      0.      5.      50.     5.      0.      5.\n' > straight.crd
plot straight.crd
[ "$status" = 0 ] && [ ! -s err ] && grep -q 'card 1' straight-plots/conics.svg && grep -q 'straight.crd' straight-plots/conics.svg
ok $? 'one level line makes a picture, named card 1 and titled by the deck' "$(seen)"
printf 'UNITS   MM\n* far side\n-90000.59999.01 0.      -90000.29999.05 -90000.19999.2  999.999 .1\n' > far.crd
plot far.crd --format txt
[ "$status" = 0 ] && grep -q -- '-90000.3' out && grep -q 'station (STA), mm' out
ok $? 'far from the origin the axes still tell their places' "$(seen)"
awk 'BEGIN { for (i = 1; i <= 300; i++) printf "%8.2f%8.2f0.      %8.2f%8.2f%8.2f0.      999.999 1.\n",
    0, -i, .7*i, -.7*i, i }' > crowd.crd
plot crowd.crd
[ "$status" = 0 ] && [ ! -s err ] && [ "$(grep -c '^# curve' crowd-plots/conics.dat)" = 300 ]
ok $? 'three hundred curves are drawn' "$(seen)"
{ head -n 10 "$deck"; echo 'bad card'; tail -n +11 "$deck"; } > half.crd
plot half.crd
[ "$status" = 1 ] && grep -q '^half.crd:11:' err && [ -s half-plots/side.svg ]
ok $? 'a bad card is reported, the others are drawn: status 1' "$(seen)"

# Names that would like to be commands, of the shell or of gnuplot, by any of their quotes.
dir='it'\''s a "d$(touch sunk)" `touch sunk` ; touch sunk #'
{
    printf '%s\n' 'TITLE   '\''; system "touch sunk"; x='\'' $(touch sunk) `touch sunk`'
    printf '%s\n' '* @heading side '\''@heading'\'' "@heading" '\'' . system("touch sunk") . '\'''
    printf '%s\n' '-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.'
    printf '%s\n' '* "; system "touch sunk"; y=" side {/Bold a}_b^c \n\047 <&> `touch sunk`'
    printf '%s\n' '-30.    -10.    -.384   0.      -18.    50.     -24.1   -.0871  5.'
    printf '* side \001\033[31m\377 caf\303\251\r\n'
    printf '%s\n' '-30.    -10.    -.268   0.      -16.    50.     -21.2   -.0697  5.'
} > hostile.crd
plot hostile.crd -o "$dir"
[ "$status" = 0 ] && [ ! -s err ] && [ -s "$dir/side.svg" ]
ok $? 'hostile names of folder, title and lines are drawn' "$(seen)"
[ -z "$(find . -name sunk)" ]
ok $? 'and no command in them was obeyed' "$(find . -name sunk)"
cat > names.gp <<'END'
load 'side.gp'
set print 'names'
print heading
do for [i=1:curves] { print name[i] }
END
(cd "$dir" && gnuplot "$work/names.gp") 2> err
tr -d '\r' < hostile.crd | sed -n 's/^TITLE   //p; s/^\* //p' |
    LC_ALL=C sed "s/$(printf '\001')/ /; s/$(printf '\033')/ /; s/$(printf '\377')/?/" > wanted
cmp -s wanted "$dir/names"
ok $? 'gnuplot has the names as they were punched' "$(diff wanted "$dir/names"; cat err)"
if command -v xmllint > /dev/null; then
    xmllint --noout "$dir/side.svg" 2> err
    ok $? 'the SVG is sound XML' "$(cat err)"
fi

finish
