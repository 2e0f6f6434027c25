#!/bin/sh
# `loft run` and `loft check` on whole decks: how a deck may be fed, diagnostics, the contract of the
# CSV, the page of 1970 and the listing.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
deck=cards/sae700202.crd
nose='-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.'

# Runs LOFT on standard input, keeps output, messages and status.
loft() {
    "${LOFT:?}" "$@" > "$work/out" 2> "$work/err"
    status=$?
}

# Checks status, output and messages of the last run against `$work/want` and the words given.
same() {
    [ "$status" = "$1" ] && cmp -s "$work/out" "$work/want"
    ok $? "$2" "status $status
$(head -n 3 "$work/err"; diff "$work/want" "$work/out" | head -n 5)"
}

# --- ways to feed a deck
"$LOFT" run --format csv $deck > "$work/want"
loft run --format csv $deck < /dev/null;    same 0 'a deck by name'
loft run --format csv < $deck;              same 0 'no deck is standard input'
loft run --format csv - < $deck;            same 0 '- is standard input'
cat $deck | loft run --format csv -
cat $deck | "$LOFT" run --format csv > "$work/out" 2> "$work/err"; status=$?
same 0 'a deck through a pipe'
mkfifo "$work/fifo"
cat $deck > "$work/fifo" & loft run --format csv "$work/fifo"; same 0 'a deck through a FIFO'
sed 's/$/\r/' $deck > "$work/crlf.crd"
loft run --format csv "$work/crlf.crd";     same 0 'lines that end in CR LF'
tr 'A-Z' 'a-z' < $deck > "$work/lower.crd"
loft run --format csv "$work/lower.crd";    same 0 'control cards in lower case'
sed '$d' $deck > "$work/no-end.crd"
loft run --format csv "$work/no-end.crd";   same 0 'the end of the file ends a deck'
printf '%s' "$(cat $deck)" > "$work/no-feed.crd"
loft run --format csv "$work/no-feed.crd";  same 0 'a last line without a line feed'
sed 's/$/   /; s/^$/ /' $deck | awk '{ print; print "" }' > "$work/blank.crd"
loft run --format csv "$work/blank.crd";    same 0 'blank cards and blanks at the end of cards'
printf '\357\273\277' | cat - $deck > "$work/mark.crd"
loft run --format csv "$work/mark.crd";     same 0 'a byte order mark before the first card'
grep '^1,' "$work/want" > "$work/first"
for form in 5.E1 5.e1 5.0D1 5.d+1 5.+1 500.-1 50000 .5E02 '5.E 1'; do
    echo "$nose" | sed "s/50\.     -4/$(printf '%8s' "$form")-4/" > "$work/exponent.crd"
    loft run --format csv "$work/exponent.crd"
    [ "$status" = 0 ] && sed 1d "$work/out" | cmp -s - "$work/first"
    ok $? "50 may be punched as $form" "$(cat "$work/exponent.crd" "$work/err")"
done

# --- diagnostics
diagnosed() {
    printf '%s\n' "$1" > "$work/bad.crd"
    (cd "$work" && "$LOFT" check bad.crd > out 2> err); status=$?
    printf '%s\n' "$2" > "$work/want"
    cp "$work/err" "$work/said"
    [ "$status" = "$3" ] && [ ! -s "$work/out" ] && cmp -s "$work/said" "$work/want"
    ok $? "check says exactly: $(echo "$2" | head -n 1)" "status $status
$(diff "$work/want" "$work/said")"
}
diagnosed "$(echo "$nose" | sed 's/-7.1/-7,1/')" 'bad.crd:1:35-35: error: Y2: a comma in a number; the point is a full stop and fields go by columns
    -30.    -10.    .114    0.      -7,1    50.     -4.     .0523   5.
                                      ^' 1
diagnosed "$(echo "$nose" | sed 's/0.      -7.1/-30.    -10./')" 'bad.crd:1:25-40: error: points 1 and 2 coincide; three different points fix a conic
    -30.    -10.    .114    -30.    -10.    50.     -4.     .0523   5.
                            ^^^^^^^^^^^^^^^^' 1
diagnosed "$(echo "$nose" | sed 's/5\.$/-5./')" 'bad.crd:1:65-70: error: XI has the wrong sign; from -30. to 50. it is positive
    -30.    -10.    .114    0.      -7.1    50.     -4.     .0523   -5.
                                                                    ^^^^^^' 1
diagnosed "$(printf '%s\n999.99\n%s\n' "$nose" "$nose")" \
    'bad.crd:2: warning: 1 card after the end card not read; X1 of 999.99 or more ends a 1970 deck' 0
diagnosed '* no card' 'bad.crd: error: the deck has no conic card; it needs at least one, with X1 in columns 1-8 (see loft help cards)' 1
diagnosed "$(printf '%s\n' "$nose" 'LINE    MHB     SIDE')" 'bad.crd:2:1-4: error: LINE in a 1970 deck; only TITLE and UNITS may stand there, before the first conic card
    LINE    MHB     SIDE
    ^^^^' 1

printf '%s\n\0\0\n' "$nose" > "$work/binary"
loft check "$work/binary"
[ "$status" = 1 ] && grep -q '/binary:2:1-1: error: a null byte: this is a binary file' "$work/err"
ok $? 'a binary file is refused' "$(cat "$work/err")"
loft check "$LOFT"
[ "$status" = 1 ] && [ "$(wc -l < "$work/err")" -lt 20 ]
ok $? 'a program given as a deck makes little noise' "$(head -n 5 "$work/err")"
for kind in run check; do
    loft $kind /dev/null
    [ "$status" = 1 ] && grep -q '^/dev/null: error: the deck has no conic card' "$work/err"
    ok $? "$kind of an empty deck says what a deck needs" "status $status"
done

loft run --format csv cards/faults.crd
[ "$status" = 1 ] && [ "$(cut -d, -f1 "$work/out" | uniq | tr '\n' ' ')" = 'card 1 2 16 17 32 34 ' ]
ok $? 'the sound cards of a bad deck still run, their numbers counting the bad ones' "$(cut -d, -f1 "$work/out" | uniq)"
"$LOFT" check cards/faults.crd 2>&1 | grep -c ': error: ' > "$work/errors"
grep -c ': error: ' "$work/err" | cmp -s - "$work/errors"
ok $? 'run reports the errors that check reports' "$(grep -c ': error: ' "$work/err")"
awk '/: (error|warning): / { split($0, part, ":"); split(part[3], at, "-"); getline card; getline carets
    if (part[3] !~ /^[0-9]+-[0-9]+$/) next
    first = match(carets, /\^/) - 4
    if (first != at[1] || length(carets) - 4 != at[2]) print "line " NR ": " $0 }' "$work/err" > "$work/wrong"
[ ! -s "$work/wrong" ]
ok $? 'the carets stand under the columns that are named' "$(cat "$work/wrong")"

# --- what stopped the program of 1970 has its columns too
stopped() {
    printf '%s\n' "$2" > "$work/bad.crd"
    loft run --arithmetic s360 "$work/bad.crd"
    [ "$status" = 1 ] && grep -q "/bad.crd:1:$1: error: $3" "$work/err"
    ok $? "the program of 1970 is stopped by columns $1: $3" "status $status
$(cat "$work/err")"
}
stopped 1-64  '0.      0.      1.      1.      1.      2.      2.      1.      .5' 'this array has no unique'
stopped 65-70 "$(echo "$nose" | sed 's/5\.$/      1.    1/')" 'XI is zero: punch an increment'
stopped 65-76 "$(echo "$nose" | sed 's/5\.$/.00001/')" 'the X table would have 8000000 rows'
cat > "$work/near-zero.crd" << 'END'
100.    100.    0.      105.    101.    110.    110.    999.999 1.
END
"$LOFT" run --arithmetic s360 "$work/near-zero.crd" > "$work/page" 2> "$work/err"
[ $? = 0 ] && [ ! -s "$work/err" ] && [ "$(grep -c '^ *-1.00000$' "$work/page")" = 3 ]
ok $? 'no word where the three check values hold' "$(cat "$work/err")"
loft run --arithmetic s360 --shift -100 "$work/near-zero.crd"
[ "$status" = 0 ] && [ "$(wc -l < "$work/out")" = "$(wc -l < "$work/page")" ] &&
    grep -q '/near-zero.crd:1:1-64: warning: the check values are not -1.00000' "$work/err"
ok $? 'a shift that takes a point to zero spoils the checks, which is warned of' "$(cat "$work/err")"
stopped 1-76  "$(echo "$nose" | sed 's/^-30.   /-1.+0076/')" 'exponent overflow in the field X1'

# --- the contract of the CSV
csv() {
    printf '%s\n' "$1" > "$work/card.crd"
    "$LOFT" run --format csv "$work/card.crd" 2> "$work/err" | sed 1d
}
[ "$("$LOFT" run --format csv $deck | head -n 1)" = 'card,axis,x,y,slope,curvature' ]
ok $? 'the header of the CSV'
[ "$("$LOFT" run --format csv /dev/null 2> /dev/null)" = 'card,axis,x,y,slope,curvature' ]
ok $? 'the header stands where there is no table'
csv "$nose" > "$work/rows"
[ "$(cut -d, -f3 "$work/rows" | tr '\n' ' ')" = '-30 -25 -20 -15 -10 -5 0 5 10 15 20 25 30 35 40 45 50 ' ]
ok $? 'both ends stand, and a step that equals the end once' "$(cut -d, -f3 "$work/rows" | tr '\n' ' ')"
[ "$(sed -n '1s/,[^,]*$//p' "$work/rows")" = '1,X,-30,-10,0.114' ] && [ "$(sed -n '$s/,[^,]*$//p' "$work/rows")" = '1,X,50,-4,0.0523' ]
ok $? 'the ends have their ordinates and slopes as punched'
[ "$(csv "$(echo "$nose" | sed 's/5\.$/7./')" | cut -d, -f3 | tail -n 2 | tr '\n' ' ')" = '47 50 ' ]
ok $? 'the end stands behind the last step'
[ "$(csv "$(echo "$nose" | sed 's/5\.$/100./')" | cut -d, -f3 | tr '\n' ' ')" = '-30 50 ' ]
ok $? 'a step past the end leaves both ends'
[ "$(csv '0.      0.      0.      .5      .025    1.      .1      .2      .1' | cut -d, -f3 | tr '\n' ' ')" \
    = '0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1 ' ]
ok $? 'tenths are stepped in decimals'
csv '-5.     0.      999.999 -4.     3.      0.      5.      0.      1.    1.     1' > "$work/rows"
[ "$(cut -d, -f2 "$work/rows" | uniq -c | tr -s ' \n' ' ')" = ' 6 X 6 Y ' ] && grep -qx '1,X,-5,0,inf,-0.2' "$work/rows"
ok $? 'ITYP and YI make a Y table behind the X table; a vertical slope is inf' "$(cat "$work/rows")"
csv '-5.     0.      999.999 -4.     3.      0.      5.      0.            1.     1' > "$work/rows"
[ "$(cut -d, -f2 "$work/rows" | uniq)" = Y ]
ok $? 'a blank XI beside an ITYP makes a Y table alone' "$(cat "$work/rows")"
csv '-5.     0.      999.999 -4.     3.      0.      5.      0.      1.    1.' > "$work/rows"
[ "$(cut -d, -f2 "$work/rows" | uniq)" = X ]
ok $? 'without ITYP there is no Y table'
[ "$("$LOFT" run --format csv $deck | sed 1d | cut -d, -f1 | uniq | tr '\n' ' ')" = '1 2 3 4 5 6 7 8 9 10 11 ' ]
ok $? 'cards are counted from 1'
printf '%s\n999.99\n%s\n' "$nose" "$nose" > "$work/card.crd"
loft run --format csv "$work/card.crd"
[ "$status" = 0 ] && [ "$(sed 1d "$work/out" | cut -d, -f1 | uniq)" = 1 ] && grep -q 'card.crd:2: warning: 1 card after' "$work/err"
ok $? 'nothing runs after X1 of 999.99, and that is warned of'
printf '%s\n%s\n' '999.989 0.      0.      1009.   .025    1019.   .1      .01     5.' "$nose" > "$work/card.crd"
loft run --format csv "$work/card.crd"
sed 1d "$work/out" | cut -d, -f1 | uniq | tr '\n' ' ' | grep -q '2 $'
ok $? 'X1 of 999.989 does not end the deck' "$(cat "$work/out" "$work/err")"
for name in sae700202 closed-forms; do
    "$LOFT" run --format csv cards/$name.crd 2> /dev/null | sed 1d |
        grep -Evx '[1-9][0-9]*,[XY](,-?(0|0\.[0-9]*[1-9]|[1-9][0-9]*(\.[0-9]*[1-9])?)(e[-+][0-9]+)?){2},(inf|-?[0-9.]+(e[-+][0-9]+)?),-?[0-9.]+(e[-+][0-9]+)?' > "$work/wrong"
    [ ! -s "$work/wrong" ]
    ok $? "every row of $name is six fields with numbers in their shortest form" "$(head -n 3 "$work/wrong")"
done

# --- the page of 1970
"$LOFT" run --arithmetic s360 $deck > "$work/page"
"$LOFT" run --arithmetic s360 --asa $deck > "$work/asa"
awk '{ control = substr($0, 1, 1); text = substr($0, 2); sub(/ +$/, "", text)
    if (control == "1") printf "\f"; if (control == "0") print ""; print text }' "$work/asa" | cmp -s - "$work/page"
ok $? 'carriage control applied to --asa gives the page with form feeds'
[ "$(tr -dc '\f' < "$work/page" | wc -c)" = 16 ] && [ "$(grep -c '^1' "$work/asa")" = 16 ]
ok $? 'each table begins a page'
! cut -c1 "$work/asa" | grep -q '[^ 01]'
ok $? 'column 1 of --asa is carriage control'
printf '%s\n' "$(echo "$nose" | sed 's/5\.$/-5./')" > "$work/card.crd"
loft run --arithmetic s360 "$work/card.crd"
[ "$status" = 1 ] && [ "$(wc -l < "$work/out")" = 6 ] && grep -q '^ *-35\.000 ' "$work/out" &&
    grep -q 'card.crd:1:65-70: error: XI has the wrong sign' "$work/err"
ok $? 'an increment of the wrong sign prints its one row; the fault goes to standard error' "$(cat "$work/out" "$work/err")"
printf '%s\n' "$(echo "$nose" | sed 's/5\.$//')" > "$work/card.crd"
loft run --arithmetic s360 "$work/card.crd"
[ "$status" = 1 ] && grep -q '^ *INVALID INCREMENT OF X OR Y$' "$work/out" && grep -c 'error: ' "$work/err" | grep -qx 1
ok $? 'an increment of zero prints the message of 1970 and is one fault' "$(cat "$work/out" "$work/err")"
printf '%s\n%s\n' '0.      0.      1.      5.      5.      10.     10.     1.      1.' "$nose" > "$work/card.crd"
loft run --arithmetic s360 "$work/card.crd"
[ "$status" = 1 ] && [ "$(head -n 1 "$work/out")" = 'THIS ARRAY HAS NO UNIQUE SOLUTION' ] && grep -q '45\.000' "$work/out"
ok $? 'a singular array prints the message of 1970, and the next card runs' "status $status $(head -n 3 "$work/out"; cat "$work/err")"
loft run --arithmetic s360 cards/faults.crd
[ "$status" = 1 ] && ! grep -q 'error' "$work/out"
ok $? 'no diagnostic stands on the page of 1970'

# --- the listing of today
for name in sae700202 closed-forms faults; do
    "$LOFT" run cards/$name.crd > "$work/listing" 2> "$work/err"
    ! tr -d '\f' < "$work/listing" | grep -q '.\{81\}'
    ok $? "no line of the listing of $name is wider than 80 columns" "$(tr -d '\f' < "$work/listing" | grep '.\{81\}')"
    ! grep -Eq -- '-0?\.0+( |$)' "$work/listing"
    ok $? "there is no -0.000 in the listing of $name" "$(grep -E -- '-0?\.0+( |$)' "$work/listing")"
    ! grep -Eq '[*]{2}|NaN|Infinity' "$work/listing"
    ok $? "every number of the listing of $name is a number"
    awk '/PAGE [0-9]+$/ { if ($NF != ++page) exit 1; lines = 0 } ++lines > 60 { exit 1 }' "$work/listing"
    ok $? "pages of the listing of $name are numbered and have at most 60 lines"
done
! grep -Eq -- '-0?\.0+( |$)' "$work/page"
ok $? 'there is no -0.000 on the page of 1970'
printf '* %s\n%s\n' "$(printf '%078d' 0)" "$nose" > "$work/long.crd"
"$LOFT" run "$work/long.crd" > "$work/listing"
! grep -q '.\{81\}' "$work/listing" && grep -q '[0-9] .*LINE 2$' "$work/listing"
ok $? 'a long name of a card is cut to fit its line' "$(grep 'LINE 2' "$work/listing")"
long="$work/$(printf '%0100d' 0).crd"
cp $deck "$long"
"$LOFT" run "$long" > "$work/listing"
! tr -d '\f' < "$work/listing" | grep -q '.\{81\}' && grep -q '^000.* LOFT' "$work/listing"
ok $? 'a long name of a deck is cut to fit its line' "$(grep '^000' "$work/listing" | head -n 1)"
finish
