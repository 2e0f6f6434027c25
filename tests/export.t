#!/bin/sh
# loft export: every format of several decks, the same bytes each time, receipts, options, what
# clumsy users do, files that appear whole or not at all, progress on a terminal.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
loft=${LOFT:?} cards=$PWD/cards
work=$(mktemp -d) && trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
chmod 755 "$work"
cd "$work" || exit 1

# Runs loft export, keeps output, messages and status.
export_deck() {
    "$loft" export "$@" > out 2> err < /dev/null
    status=$?
}
# What went on in the last run.
seen() { echo "status $status"; head -n 30 out; cat err; }
# The value of a line of a receipt: said WORD FILE
said() { sed -n "s/^$1  *//p" "$2"; }

# --- every format of several decks --------------------------------------------------------------

# A deck becomes a file, twice the same, with a receipt that keeps what it says.
makes() {
    deck=$1 file=$2; shift 2
    export_deck "$cards/$deck.crd" -o "$file" "$@"
    [ "$status" = 0 ] && [ ! -s err ] && [ -s "$file" ] && cmp -s out "$file.receipt"
    ok $? "$deck as $file${*:+ $*}, its receipt beside it and on standard output" "$(seen)"
    [ "$(said FILE out)" = "$file" ] && [ "$(said DECK out)" = "$deck.crd" ] &&
        [ "$(said SHA-256 out)" = "$(sha256sum < "$cards/$deck.crd" | cut -d' ' -f1)" ] &&
        [ "$(head -n 1 out)" = "$("$loft" --version | sed 's/loft/LOFT/') EXPORT RECEIPT" ]
    ok $? "$file: the receipt names file, deck, checksum and version" "$(seen)"
    ! grep -q '.\{101\}' out
    ok $? "$file: the receipt is no wider than 100 columns" "$(grep '.\{101\}' out)"
    awk -v most="$(said TOLERANCE out)" '/^LARGEST ERROR/ { found = 1
        good = most == "NONE" || $3 + 0 <= most*(1 + 1e-9) } END { exit !(found && good) }' out
    ok $? "$file: no error is larger than the tolerance" "$(grep LARGEST out)"
    mkdir again
    "$loft" export "$cards/$deck.crd" -o "again/$file" "$@" > again/out 2>&1
    cmp -s "$file" "again/$file" && cmp -s out again/out
    ok $? "$file: the same bytes again, file and receipt"
    rm -r again
}
curve_files='svg pdf dxf igs step nc' body_files='stl obj hrm wgs csv'
for ending in $curve_files $body_files; do
    makes nose "nose.$ending"
done
# Of the large decks a few cuts; the judges read them whole.
{ sed '/^FLANGE  AFT/,$d' "$cards/fuselage.crd"; echo END; } > fuselage.crd
{ sed '/^POINTS/,$d' "$cards/ellipsoid.crd"; echo END; } > ellipsoid.crd
cards=$work
for ending in svg dxf step stl; do
    makes fuselage "fuselage.$ending"
done
for ending in pdf igs obj wgs; do
    makes ellipsoid "ellipsoid.$ending"
done
cards=$ROOT/cards
for ending in $curve_files; do
    makes sae700202 "sae700202.$ending"
done
makes nose nose-splines.dxf --dxf-splines
makes nose nose-space.dxf --3d --units mm
makes nose nose-conics.iges --iges-conics
makes nose nose-tiles.pdf --paper a4 --sheet all --half
makes nose nose-roll.pdf --paper roll 24
makes nose nose-binary.stl --binary --angle 20
makes nose nose-open.stp --open --units mm

for ending in $body_files; do
    export_deck "$cards/sae700202.crd" -o "no.$ending"
    [ "$status" = 2 ] && [ ! -s out ] && [ ! -e "no.$ending" ] && grep -q 'a 1970 deck has no body.*svg pdf' err
    ok $? "a 1970 deck has nothing for .$ending, and that is said" "$(seen)"
done

# --- what the files are ------------------------------------------------------------------------

head -c 5 nose.pdf | grep -q '%PDF-';              ok $? 'PDF is PDF'
head -n 3 nose.svg | grep -q '<svg';               ok $? 'SVG is SVG'
head -n 2 nose.dxf | tail -n 1 | grep -q SECTION;  ok $? 'DXF is DXF'
head -n 1 nose.step | grep -q '^ISO-10303-21;';    ok $? 'STEP is STEP'
cut -c73 nose.igs | sort -u | tr -d '\n' | grep -q '^DGPST$' && ! grep -qv '^.\{80\}$' nose.igs
ok $? 'IGES is cards of 80 columns in five sections'
head -n 1 nose.stl | grep -q '^solid';             ok $? 'STL is text'
[ "$(wc -c < nose-binary.stl)" -gt 84 ] && ! head -n 1 nose-binary.stl | grep -q '^solid'
ok $? 'binary STL does not begin like text'
grep -q '^G20' nose.nc && grep -q '^M30' nose.nc;  ok $? 'NC is a program in inches'

# --- options -----------------------------------------------------------------------------------

makes nose mm.dxf --units mm
[ "$(said UNITS out)" = MM ] && [ "$(said TOLERANCE out)" = 0.0254 ]
ok $? '--units mm: unit and tolerance are those of the file' "$(seen)"
makes nose fine.dxf --tolerance 1e-6
[ "$(said TOLERANCE out)" = '1e-06' ] || [ "$(said TOLERANCE out)" = 0.000001 ]
ok $? '--tolerance 1e-6' "$(seen)"
[ "$(wc -c < fine.dxf)" -gt "$(wc -c < nose.dxf)" ]
ok $? 'a finer file is larger'
makes nose cuts.dxf --cut sta_20,floor --cut 1
[ "$(sed -n 's/^\([A-Z0-9_.-]*\)  *POLYLINE.*/\1/p' out | uniq | tr '\n' ' ')" = 'STA_0 STA_20 WL_-16_FLOOR ' ]
ok $? '--cut takes numbers and names, in the order of the deck' "$(seen)"
export_deck "$cards/nose.crd" -o none.dxf --cut FRONT
[ "$status" = 2 ] && grep -q -- '--cut FRONT: no cut .* 1 STA_0, 2 STA_5' err && [ ! -e none.dxf ]
ok $? 'a cut that is not there: the cuts are listed' "$(seen)"

makes sae700202 cards.dxf --cut 'mhb side,3'
[ "$(said '[A-Za-z]*_[a-z]*' out | wc -l)" = 2 ] && grep -q '^MHB_side ' out && grep -q '^LCL_side ' out
ok $? 'cards of a deck of 1970 are chosen by their comment and by number' "$(seen)"

mkdir sheets
export_deck "$cards/nose.crd" -o sheets/nose.svg --sheet each
[ "$status" = 0 ] && [ "$(ls sheets | wc -l)" = 11 ] && [ -s sheets/nose-STA_20.svg ] &&
    [ -s sheets/nose-WL_-16_FLOOR.svg ] && [ -s sheets/nose.svg.receipt ] && [ ! -e sheets/nose.svg ]
ok $? '--sheet each: a file for each cut, one receipt' "$(seen; ls sheets)"
[ "$(sed -n '/^FILE/,/^DECK/p' out | grep -c '\.svg$')" = 10 ]
ok $? 'the receipt names all files' "$(seen)"
mkdir half-done && ln -s /dev/full half-done/nose-STA_30.svg
export_deck "$cards/nose.crd" -o half-done/nose.svg --sheet each
[ "$status" = 2 ] && grep -q 'nose-STA_30.svg: No space left' err && [ "$(ls half-done)" = nose-STA_30.svg ]
ok $? 'where one of the files fails none is made' "$(seen; ls half-done)"

# --- standard input and output ------------------------------------------------------------------

for format in pdf dxf iges step stl obj nc hrm wgs csv svg; do
    file=nose.$format
    [ -e "$file" ] || file=nose.igs
    "$loft" export "$cards/nose.crd" -o - --format $format > piped 2> err
    status=$?
    # Formats may name themselves: STEP and IGES files hold the name of the deck, not their own.
    [ "$status" = 0 ] && cmp -s piped "$file" && grep -q '^LOFT .* EXPORT RECEIPT$' err && [ ! -e -.receipt ]
    ok $? "-o - --format $format: the file on standard output, the receipt on standard error" "$(head -n 9 err)"
done
"$loft" export - -o stdin.dxf < "$cards/nose.crd" > out 2> err
[ "$(said SHA-256 out)" = "$(sha256sum < "$cards/nose.crd" | cut -d' ' -f1)" ] && [ "$(said DECK out)" = 'standard input' ]
ok $? 'a deck from standard input has its checksum' "$(cat out err)"
{ cat "$cards/sae700202.crd"; printf 'after the end\n%0100000d' 7; } > tail.crd
export_deck tail.crd -o tail.dxf
[ "$(said SHA-256 out)" = "$(sha256sum < tail.crd | cut -d' ' -f1)" ]
ok $? 'the checksum is of all bytes, also of those behind the end of the deck' "$(seen)"
sed 's/$/\r/' "$cards/nose.crd" > dos.crd
export_deck dos.crd -o dos.dxf
[ "$status" = 0 ] && [ "$(said SHA-256 out)" = "$(sha256sum < dos.crd | cut -d' ' -f1)" ]
ok $? 'carriage returns count' "$(seen)"
for device in /dev/null /dev/stdout; do
    "$loft" export "$cards/nose.crd" -o $device --format nc > piped 2> err
    status=$?
    [ "$status" = 0 ] && [ ! -e $device.receipt ] && grep -q 'EXPORT RECEIPT' err
    ok $? "-o $device: no receipt beside it" "$(cat err)"
done
mkfifo fifo && cat fifo > through & export_deck "$cards/nose.crd" -o fifo --format nc; wait
[ "$status" = 0 ] && cmp -s through nose.nc && [ ! -e fifo.receipt ] && [ ! -s out ]
ok $? 'a FIFO is written through; the receipt goes to standard error' "$(seen)"
echo old > real.nc && ln -s real.nc link.nc
export_deck "$cards/nose.crd" -o link.nc
[ "$status" = 0 ] && [ -L link.nc ] && cmp -s real.nc nose.nc && [ -s link.nc.receipt ]
ok $? 'a link is written through, the receipt stands beside it' "$(seen)"
"$loft" export "$cards/nose.crd" -o closed.nc >&- 2> err
status=$?
[ "$status" = 2 ] && grep -q '^loft: standard output: ' err && cmp -s closed.nc nose.nc
ok $? 'with standard output closed the file is whole; that the receipt is not shown is said' "$(cat err)"

# --- clumsy users -------------------------------------------------------------------------------

# The command is refused in one line and leaves everything as it was: refused 'phrase' 'words' ARGUMENTS...
listed() { ls -lA | grep -v '^total\| \(before\|after\|out\|err\)$'; }
refused() {
    phrase=$1 words=$2; shift 2
    listed > before; export_deck "$@"; listed > after
    [ "$status" = 2 ] && [ ! -s out ] && grep -qF -- "$words" err && [ "$(wc -l < err)" = 1 ]
    ok $? "refused: $phrase" "$(seen)"
    cmp -s before after
    ok $? "and nothing is left: $phrase" "$(diff before after)"
}
nose=$cards/nose.crd
refused 'no -o' 'loft export needs -o FILE' "$nose"
refused 'no deck' 'needs a deck' -o a.svg
refused 'two decks' 'takes one deck' "$nose" "$nose" -o a.svg
refused 'an unknown ending' '-o a.dwg: its ending says no format; endings: .svg .pdf' "$nose" -o a.dwg
refused 'no ending' '-o drawing: its ending' "$nose" -o drawing
refused 'an option of another format' '--3d does not go with svg, but with: dxf' "$nose" -o a.svg --3d
refused 'paper for a mesh' '--paper does not go with stl, but with: svg pdf' "$nose" -o a.stl --paper a4
refused 'a tolerance in words' '--tolerance' "$nose" -o a.svg --tolerance fine
refused 'no tolerance at all' 'above 0' "$nose" -o a.svg --tolerance 0
refused 'a unit in full' '--units' "$nose" -o a.svg --units inches
refused 'a roll without its width' '--paper roll' "$nose" -o a.svg --paper roll
refused 'a missing deck' 'missing.crd: No such file' missing.crd -o a.svg
refused 'a folder for a deck' 'sheets: Is a directory' sheets -o a.svg
refused 'a missing folder' 'none/a.dxf: No such file' "$nose" -o none/a.dxf
refused 'sheets in a missing folder' 'none/a.svg: No such file' "$nose" -o none/a.svg
refused 'a folder for a file' ': Is a directory' "$nose" -o sheets/../sheets --format dxf
refused 'a full device' '/dev/full: No space left' "$nose" -o /dev/full --format dxf
cp "$nose" deck.svg
refused 'the deck as the result' '-o deck.svg would replace the deck' deck.svg -o deck.svg
refused 'the deck by another name' 'would replace the deck' deck.svg -o ./deck.svg
cp "$nose" a.nc.receipt
refused 'the deck as the receipt' 'a.nc.receipt would replace the deck' a.nc.receipt -o a.nc
cmp -s deck.svg "$nose" && cmp -s a.nc.receipt "$nose"
ok $? 'the decks are as they were'
rm a.nc.receipt
mkdir b.nc.receipt
refused 'a folder where the receipt goes' 'b.nc.receipt: Is a directory' "$nose" -o b.nc
printf 'TITLE NOTHING\n' > bare.crd
: > empty.crd
for format in svg dxf nc igs step stl hrm; do
    export_deck empty.crd -o "e.$format"
    [ "$status" -gt 0 ] && [ ! -e "e.$format" ] && [ ! -e "e.$format.receipt" ] && [ -s err ] && [ ! -s out ]
    ok $? "an empty deck as .$format is refused" "$(seen)"
    export_deck bare.crd -o "e.$format"
    [ "$status" -gt 0 ] && [ ! -e "e.$format" ] && [ ! -e "e.$format.receipt" ] && [ -s err ] && [ ! -s out ]
    ok $? "a deck of a title as .$format is refused" "$(seen)"
done
grep -v '^\(STATION\|WATERLN\|BUTTOCK\|OBLIQUE\)' "$nose" > uncut.crd
for format in svg pdf dxf nc; do
    export_deck uncut.crd -o "u.$format"
    [ "$status" = 2 ] && [ ! -e "u.$format" ] && grep -q 'STATION' err
    ok $? "a deck without cuts as .$format: the message says what card to add" "$(seen)"
done
export_deck uncut.crd -o u.step
[ "$status" = 0 ] && [ -s u.step ]
ok $? 'a deck without cuts has a skin' "$(seen)"
grep -v '^\(SECTION\|STATION\|WATERLN\|BUTTOCK\|OBLIQUE\)' "$nose" > lines.crd
export_deck lines.crd -o l.stl
[ "$status" = 2 ] && grep -q 'SECTION card' err
ok $? 'a deck without sections has no mesh; the message says what card to add' "$(seen)"

"$loft" export "$nose" -o first.nc -o second.nc > out 2> err; status=$?
[ "$status" = 2 ] && [ ! -e second.nc ] && [ ! -e first.nc ]
ok $? 'a second -o is refused' "$(seen)"
odd="a deck's \"odd\" name.nc"
export_deck "$nose" -o "$odd"
[ "$status" = 0 ] && cmp -s "$odd" nose.nc && [ -s "$odd.receipt" ]
ok $? 'names may have blanks and quotes' "$(seen)"

# --- faulty decks -------------------------------------------------------------------------------

sed 's/^STATION 0\..*/STATION 900./' "$nose" > faulty.crd
export_deck faulty.crd -o faulty.nc
"$loft" run faulty.crd > /dev/null 2> run.err
[ "$status" = 1 ] && [ -s faulty.nc ] && cmp -s out faulty.nc.receipt && cmp -s err run.err && grep -q 'WL_-16' out
ok $? 'a bad card is shown as loft run shows it; the others are exported, status 1' "$(seen)"
sed '/^-30/s/50\.0 /-30.0/' "$cards/sae700202.crd" > faults.crd
export_deck faults.crd -o faults.dxf
"$loft" run faults.crd > /dev/null 2> run.err
[ "$status" = 1 ] && [ -s faults.dxf ] && cmp -s err run.err
ok $? 'so it is with a 1970 deck' "$(seen)"
printf 'BODY\nLINE A B\n' > broken.crd
export_deck broken.crd -o broken.step
[ "$status" = 1 ] && [ ! -e broken.step ] && [ -s err ] && [ ! -s out ]
ok $? 'where nothing is sound the faults are shown and nothing is written' "$(seen)"

# --- several bodies ----------------------------------------------------------------------------

{ grep -v '^END' "$nose"; echo 'BODY    SECOND'; sed -n '/^LINE/,$p' "$nose"; } > two.crd
for format in dxf step stl; do
    export_deck two.crd -o two.$format
    [ "$status" = 0 ] && [ "$(wc -c < two.$format)" -gt "$(($(wc -c < nose.$format)*3/2))" ]
    ok $? "two bodies are in one file: .$format" "$(seen)"
done
grep -q '^STA_20-2 ' two.dxf.receipt
ok $? 'their cuts have different names' "$(cat two.dxf.receipt)"

# --- signals ------------------------------------------------------------------------------------

mkfifo slow.crd
echo old > kept.nc
perl -e '$SIG{INT} = "DEFAULT"; exec @ARGV' "$loft" export slow.crd -o kept.nc > out 2> err &
run=$!
exec 3> slow.crd
head -n 8 "$nose" >&3
kill -INT $run
wait $run 2> /dev/null
status=$?
exec 3>&-
[ "$status" = 130 ] && [ "$(cat kept.nc)" = old ] && [ -z "$(find . -name '*.part*')" ]
ok $? 'SIGINT ends loft export by that signal, and nothing is changed' "$(seen; ls)"
[ -z "$(find . -name '*.part*')" ]
ok $? 'no unfinished file is left' "$(find . -name '*.part*')"

# --- many cards -------------------------------------------------------------------------------------

# A sheet of PDF or a layer of DXF for each of many cards: time goes with their number, not with its square.
awk 'BEGIN { for (i = 1; i <= 4000; i++) { print "* CARD " i
    print "-30.0   -10.0   .114    0.0     -7.1    50.0    -4.0    .0523   5.0" } }' > many.crd
for ending in pdf dxf svg; do
    (ulimit -t 30; export_deck many.crd -o many.$ending; exit "$status") && [ -s many.$ending.receipt ]
    ok $? "four thousand cards as $ending take no longer than they may" "$(ls -l many.*)"
done
rm many.*

# --- progress -----------------------------------------------------------------------------------

if ! script -qec true /dev/null > /dev/null 2>&1; then
    echo '# no script(1) on this machine: progress is not tested'
    finish; exit
fi
# On a terminal: a job that waits for its deck longer than two seconds, and a short one.
mkfifo late.crd
{ head -n 8 "$nose"; sleep 2.6; tail -n +9 "$nose"; } > late.crd &
script -qec "'$loft' export late.crd -o late.nc > late.out" /dev/null > shown < /dev/null
wait
tr '\r' '\n' < shown | grep -q '^loft: reading the deck' && [ -s late.nc ]
ok $? 'after two seconds a terminal is told what is done' "$(cat -v shown)"
[ "$(tail -c 4 shown | od -An -c | tr -d ' \n')" = '\r033[K' ]
ok $? 'at the end the line is wiped away' "$(cat -v shown)"
! grep -q 'reading' late.out && cmp -s late.out late.nc.receipt
ok $? 'standard output has the receipt alone' "$(cat late.out)"
script -qec "'$loft' export '$nose' -o short.nc > short.out" /dev/null > shown < /dev/null
[ ! -s shown ] && [ -s short.nc ]
ok $? 'a short job tells nothing' "$(cat -v shown)"

finish
