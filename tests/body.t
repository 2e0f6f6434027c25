#!/bin/sh
# `loft run` and `loft check` on body decks: the contract of the CSV, the example of the design, what
# a clumsy deck gets told, several bodies, both sides, units of the listing.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
nose=cards/nose.crd

# Runs LOFT on a deck, keeps output, messages and status.
loft() {
    "${LOFT:?}" "$@" > "$work/out" 2> "$work/err"
    status=$?
}

# Checks that the last run ended with a status and that a file of it has a line like a pattern.
has() {
    [ "$status" = "$1" ] && grep -q -- "$3" "$work/$2"
    ok $? "$4" "status $status; wanted: $3
$(head -n 5 "$work/$2")"
}

# --- the nose of the book from its control lines alone
loft run --format csv $nose
has 0 out '^cut,kind,section,sta,bl,wl,slope,curvature,bevel$' 'the header is the contract'"'"'s'
has 0 out '^1,station,LOWER,0,0,-18,0,' 'the first station begins on the centre line'
has 0 out ',inf,' 'a section ends vertical at the maximum half-breadth'
for kind in station buttock waterline oblique; do has 0 out "^[0-9]*,$kind," "it has a $kind"; done
awk -F, 'NR > 1 && NF != 9 { bad = 1 } END { exit bad }' "$work/out"
ok $? 'every row has nine fields'
awk -F, '$2 == "buttock" { print $4 }' "$work/out" | tr '\n' ' ' | grep -q '^0 5 10 15 20 $'
ok $? 'a buttock has one point for each stepped station, both ends included'
awk -F, '$2 == "station" && $1 == 1' "$work/out" | grep -c . | grep -qx 25
ok $? 'a station has 25 points'
loft run $nose
[ "$status" = 0 ] && ! tr -d '\f' < "$work/out" | awk 'length > 80' | grep -q .
ok $? 'the listing keeps to 80 columns'
has 0 out 'POSITIVE AFT' 'it has a datum'
has 0 out 'HEIGHTS (WL) ON BUTT LINES' 'and tables of offsets'
has 0 out 'NO VOLUME' 'an open quarter has no volume, and that is said'
sed '/nose.crd/d' "$work/out" > "$work/a"; "$LOFT" run - < $nose | sed '/^-  /d' > "$work/b"
cmp -s "$work/a" "$work/b"; ok $? 'a body deck may come from a pipe'

# --- the point of the nose
sed 's/^STATION.*/STATION -30./' $nose > "$work/point.crd"
loft run --format csv "$work/point.crd"
has 0 out '^1,station,LOWER,-30,0,-10,,,$' 'a station at the point is that point, without slope'

# --- what a clumsy deck gets told
change() { sed "$1" $nose > "$work/deck.crd"; }
change 's/^STATION.*/STATION 100./'; loft run "$work/deck.crd"
has 1 err 'error: the cut is beyond line LCL, which goes from station -30. to 50' \
    'a cut beyond the lines names the line and its range'
has 1 out 'BUTT LINE 4.500' 'and the other cuts are made'
change 's/^SECTION LOWER   LCL     LSH/SECTION LOWER   LCL     LSX/'; loft run "$work/deck.crd"
has 1 err 'there is no LINE LSX; did you mean LSH?' 'a wrong name is told with the likely one'
[ "$(grep -c error: "$work/err")" = 1 ]; ok $? 'and nothing else is said that follows from it'
change 's/^BUTTOCK.*/BUTTOK  4.5     0.      20.     5./'; loft check "$work/deck.crd"
has 1 err 'BUTTOCK' 'a wrong word is told with the nearest right one'
change 's/^BUTTOCK.*/BUTTOCK 40.     0.      20.     5./'; loft run "$work/deck.crd"
has 0 out 'DOES NOT MEET' 'a plane that misses the skin says so'
change '/^END/a STATION 1.'; loft check "$work/deck.crd"
has 0 err 'warning: 1 card after the END' 'cards after END are counted'
loft run --arithmetic s360 $nose
has 2 err 'body deck' 'the arithmetic of 1970 has no body decks'
change 's/^LINE    LSH     PLAN/LINE    LSH     PLNA/'; loft check "$work/deck.crd"
has 1 err 'PLAN' 'a wrong view is told'

# --- no more points than a table has, and nothing said twice of a card
change 's/^BUTTOCK.*/POINTS  LENGTH  1.E-9\nSTATION 5./'; loft run "$work/deck.crd"
has 1 err 'too many; LOFT makes at most 100000 points' 'points without number are refused, with their bound'
change 's/^STATION.*/SKIN    20.\nSTATION LIST    50.     50./'; loft run "$work/deck.crd"
[ "$(sort "$work/err" | uniq -d | grep -c warning:)" = 0 ]; ok $? 'what is said of one cut is not said again of the next' "$(cat "$work/err")"

# --- a plane that touches a straight side
printf 'LINE,%s\n' 'TOP,SIDE,5.' 'MID,SIDE,0.' 'MID,PLAN' > "$work/touch.crd"
printf '%s\n' 'STRAIGHT,0.,5.,20.,7.' 'STRAIGHT,20.,7.,60.,7.,KNUCKLE' 'LINE,SHL,SIDE,4.' 'LINE,SHL,PLAN,4.5' \
    'SECTION,UPPER,TOP,SHL,MID,0.,999.999' 'BUTTOCK,7.,0.,60.,20.' >> "$work/touch.crd"
loft run "$work/touch.crd"
has 0 out '^ *20.000 *7.000 *0.000 *-90.000$' 'a plane that touches the skin has points without slope and curvature'
has 0 out '^OUTLINE 1 OF 1, OPEN$' 'the line on which it touches is found, once'

# --- units, feet-inches-eighths, wide pages
change 's/^UNITS.*/OUTPUT  FIE/'; loft run "$work/deck.crd"
has 0 out '-1-06-0' 'WL -18 in is -1-06-0 in feet, inches and eighths'
change 's/^UNITS.*/OUTPUT  MM/'; loft run "$work/deck.crd"
has 0 out '-457.200' 'and -457.2 in millimetres'
change 's/^UNITS.*/PAGE    132     50/'; loft run "$work/deck.crd"
[ "$(head -n 1 "$work/out" | awk '{ print length }')" = 132 ]; ok $? 'pages may be 132 wide'
has 0 out 'STA$' 'and have their heads'

# --- both sides
sed 's/^UNITS.*/SYMMETRY,NO/; s/^SECTION.*/SECTION,LOWER,LCL,LSH,MHB,0.,999.999,,,BOTH/' $nose > "$work/both.crd"
loft run --format csv "$work/both.crd"
awk -F, '$1 == 1 { n++; if ($5 < 0) port++ } END { exit !(n == 50 && port == 24) }' "$work/out"
ok $? 'with SYMMETRY NO a section of BOTH sides stands on both' "$(head -n 3 "$work/out"; cat "$work/err")"

# --- several bodies
{ sed '/^END/d' $nose; echo 'BODY    SECOND'; sed '/^TITLE/d; /^UNITS/d; /^\*/d' $nose; } > "$work/two.crd"
loft run "$work/two.crd"
has 0 out 'BODY SECOND' 'a deck may have several bodies'
loft run --format csv "$work/two.crd"
"$LOFT" run --format csv $nose | sed 1d | cut -d, -f2- > "$work/a"
cut -d, -f2- "$work/out" | sed 1d > "$work/b"; cat "$work/a" "$work/a" | cmp -s - "$work/b"
ok $? 'each with its own cuts'

# --- many cuts, by one thread and by three
sed 's/^STATION .*/STATION,0.,50.,.025,/' $nose > "$work/many.crd"
for form in listing csv; do
    OMP_NUM_THREADS=1 "$LOFT" run --format $form "$work/many.crd" > "$work/a" 2> "$work/err"
    OMP_NUM_THREADS=3 "$LOFT" run --format $form "$work/many.crd" > "$work/b" 2>> "$work/err"
    [ -s "$work/a" ] && cmp -s "$work/a" "$work/b"
    ok $? "2001 stations give the same bytes by three threads as by one, $form" "$(cat "$work/err")"
done
[ "$(cut -d, -f1 "$work/b" | tail -n 1)" = 2004 ]; ok $? 'all of them, and the other cuts'

# --- both forms of a deck
cmp -s cards/fuselage.crd cards/fuselage-free.crd
[ $? = 1 ]; ok $? 'the fuselage stands in columns and between commas'
"$LOFT" run --format csv cards/fuselage.crd > "$work/a" 2> "$work/err"
"$LOFT" run --format csv cards/fuselage-free.crd > "$work/b" 2> "$work/err"
cmp -s "$work/a" "$work/b"; ok $? 'both give the same figures'

finish
