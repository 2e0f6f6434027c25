#!/bin/sh
# `loft sweep` on whole decks: rows and front, threads, the best deck, stopping and going on, faulty
# decks, files that can't be written.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
deck=$work/nose.crd
sed 's/^SWEEP   LATIN   60/SWEEP   LATIN   24/' cards/sweep.crd > "$deck"

# Runs LOFT, keeps output, messages and status.
loft() {
    "${LOFT:?}" "$@" > "$work/out" 2> "$work/err" < /dev/null
    status=$?
}
# The last run has a status and a message.
said() {
    [ "$status" = "$1" ] && grep -q "$2" "$work/err"
    ok $? "$3" "status $status
$(cat "$work/err")"
}

# --- one run, and what it leaves
loft sweep "$deck" -o "$work/a.csv"
[ "$status" = 0 ] && [ ! -s "$work/err" ] && [ "$(ls "$work")" = "a.csv
a.csv.best.crd
err
nose.crd
out" ]
ok $? 'a sweep leaves rows and the best deck' "status $status $(ls "$work") $(cat "$work/err")"
awk -F, 'NR == 2 { n = NF } NR > 2 && NF < n { bad++ } NR > 2 && $1 != NR - 2 { bad++ }
    END { exit bad > 0 || NR != 26 }' "$work/a.csv"
ok $? 'one row a variant, in order' "$(head -n 5 "$work/a.csv")"
awk -F, 'function met(v, from, to) { return int((v - from)/(to - from)*24 + 1e-9) }
    NR > 2 { a[met($2, 10.5, 13)]++; b[met($3, -19, -17.2)]++; c[met($4, -.46, -.36)]++ }
    END { for (i = 0; i < 24; i++) if (a[i] != 1 || b[i] != 1 || c[i] != 1) exit 1 }' "$work/a.csv"
ok $? 'each variable has one value in each 24th of its range'
head -n 1 "$work/a.csv" | grep -q "sweep of 24 variants, deck $(sha256sum "$deck" | cut -d' ' -f1)\$"
ok $? 'the first line has the checksum of the deck' "$(head -n 1 "$work/a.csv")"
awk -F, 'NR > 2 && $9 == "ok" { v[$1] = $5; w[$1] = $6; f[$1] = $10; n++ }
    END { for (i in v) { beaten = 0
              for (k in v) if (v[k] >= v[i] && w[k] <= w[i] && (v[k] > v[i] || w[k] < w[i])) beaten = 1
              if (beaten == f[i]) bad++ }
          exit bad > 0 || n < 10 }' "$work/a.csv"
ok $? 'the front is who is not beaten by any other'
rows=$(awk -F, 'NR > 2 && $10 == 1' "$work/a.csv" | wc -l)
grep -q "^Pareto front, $rows variants:\$" "$work/out"
ok $? 'standard output has the front' "$(cat "$work/out")"
loft sweep "$deck"
sed '/^# [^l]/d; /^#  /d' "$work/out" | cmp -s - "$work/a.csv"
ok $? 'without -o the rows go to standard output, the summary behind #' "$(head -n 3 "$work/out")"

# --- the best deck
best=$(sed -n 's/^# Best: variant \([0-9]*\).*/\1/p' "$work/out")
loft run "$work/a.csv.best.crd"
[ "$status" = 0 ]; ok $? 'the best deck runs as such' "$(cat "$work/err")"
volume=$(awk -F, -v n="$best" 'NR > 2 && $1 == n { printf "%.6f", $5 }' "$work/a.csv")
grep -q "VOLUME *$volume" "$work/out"
ok $? "its volume is that of its row, $volume" "$(grep VOLUME "$work/out")"
[ "$(diff "$deck" "$work/a.csv.best.crd" | grep -c '^>')" = 5 ]
ok $? 'only the cards that vary differ' "$(diff "$deck" "$work/a.csv.best.crd")"
loft sweep "$deck" --variant "$best"
cmp -s "$work/out" "$work/a.csv.best.crd"; ok $? '--variant prints the deck of any variant'
cp "$work/a.csv.best.crd" "$work/own.csv.best.crd"
loft sweep "$work/own.csv.best.crd" -o "$work/own.csv"
said 2 'would replace the deck' 'a deck is not overwritten by its own best'

# --- what doc/sweep.md shows
loft sweep cards/sweep.crd -o "$work/sweep.csv"
sed 's|'"$work"'/||' "$work/out" > "$work/said"
sed -n '/^    \$ loft sweep/,/^$/p' doc/sweep.md | sed '1d; /^ *\.\.\.$/d; /front.svg$/d; /^$/d; s/^    //' > "$work/shown"
grep -vxFf "$work/said" "$work/shown" > "$work/other"
[ "$(wc -l < "$work/shown")" = 8 ] && [ ! -s "$work/other" ]
ok $? 'doc/sweep.md shows what LOFT prints' "$(cat "$work/other")"

# --- threads
for threads in 1 2 3 8; do
    OMP_NUM_THREADS=$threads loft sweep "$deck" -o "$work/t.csv"
    cmp -s "$work/t.csv" "$work/a.csv"; ok $? "the same bytes with $threads threads"
done

# --- stopped and resumed
for signal in KILL TERM INT; do
    for rows in 0 3 12; do
        rm -f "$work"/k.*
        # A shell lets its children in the background ignore SIGINT.
        env --default-signal=INT "$LOFT" sweep "$deck" -o "$work/k.csv" > /dev/null 2>&1 &
        pid=$!
        until [ -f "$work/k.csv" ] || [ "$(wc -l 2> /dev/null < "$work/k.csv.partial")" -ge $((rows + 2)) ] 2> /dev/null; do
            sleep 0.01
        done
        kill -$signal $pid 2> /dev/null
        wait $pid 2> /dev/null
        had=$(awk 'END { print NR - 2 }' "$work/k.csv.partial" 2> /dev/null)
        sed 1,2d "$work/k.csv.partial" > "$work/had" 2> /dev/null
        [ ! -e "$work/k.csv" ] || had=none
        loft sweep "$deck" -o "$work/k.csv" --resume
        [ "$status" = 0 ] && cmp -s "$work/k.csv" "$work/a.csv" && [ ! -e "$work/k.csv.partial" ] &&
            cmp -s "$work/k.csv.best.crd" "$work/a.csv.best.crd"
        ok $? "stopped by SIG$signal after $rows rows and resumed: the same bytes" "status $status, had $had
$(cat "$work/err")"
    done
done

# A journal made by hand: some rows, changed if need be, each with its seal.
journal() {
    sed -n "1,$1p" "$work/a.csv" | sed '3,$s/,\(ok\|limit\|fault\),[01],/,\1,,/' | sed "$2" |
        while IFS= read -r row; do
            case $row in
                [0-9]*) printf '%s,%.8s\n' "$row" "$(printf %s "$row" | sha256sum)" ;;
                *) printf '%s\n' "$row" ;;
            esac
        done > "$work/k.csv.partial"
}
# Some rows, the last one torn at every place.
torn=0
for bytes in 1 5 20 40 60 75 90 110 160 200 240 300 333; do
    rm -f "$work/k.csv"; journal 6
    head -c "$bytes" "$work/k.csv.partial" > "$work/torn"
    cp "$work/torn" "$work/k.csv.partial"
    loft sweep "$deck" -o "$work/k.csv" --resume
    [ "$status" = 0 ] && cmp -s "$work/k.csv" "$work/a.csv" || torn=$((torn + 1))
done
[ $torn = 0 ]; ok $? 'a journal torn anywhere, its header too, is gone on with' "$torn times not"
rm -f "$work/k.csv"; journal 26 '12,22s/^\(\([^,]*,\)\{7\}\)/\19/'
loft sweep "$deck" -o "$work/k.csv" --resume
[ "$status" = 0 ] && [ "$(diff "$work/k.csv" "$work/a.csv" | grep -c '^<')" = 11 ]
ok $? 'no finished variant is computed again: rows in the journal are taken as they are' "status $status"
rm -f "$work"/k.*; journal 20
loft sweep "$deck" -o "$work/k.csv"
said 2 'k.csv.partial is there.*--resume goes on with it' 'a journal is not overwritten without --resume'
sed 's/^VARY    S1.*/VARY    S1      SLOPE   -.46    -.37/' "$deck" > "$work/other.crd"
loft sweep "$work/other.crd" -o "$work/k.csv" --resume
said 2 'is of another deck, or this deck was changed' 'a changed deck is refused'
[ "$(wc -l < "$work/k.csv.partial")" = 20 ]; ok $? 'and the journal stays'
echo 'some,thing,else' >> "$work/k.csv.partial"
loft sweep "$deck" -o "$work/k.csv" --resume
said 2 'k.csv.partial:21: a row that was damaged' 'a line that is no row is named'
rm -f "$work"/k.*; journal 20
sed '9s/[1-8],ok/9,ok/; 9s/[1-8],limit/9,limit/' "$work/k.csv.partial" > "$work/changed"
cp "$work/changed" "$work/k.csv.partial"
loft sweep "$deck" -o "$work/k.csv" --resume
said 2 'k.csv.partial:9: a row that was damaged' 'so is one with another figure'
rm -f "$work"/k.*; journal 20 '7s/^\([0-9]*\),1/\1,2/'
loft sweep "$deck" -o "$work/k.csv" --resume
said 2 'k.csv.partial:7: no row of this sweep' 'so is one whose variables are not those of its variant'
journal 5; mv "$work/k.csv.partial" "$work/had"; head -n 5 "$work/a.csv" > "$work/k.csv"
"$LOFT" sweep "$deck" -o "$work/k.csv" --resume > /dev/null 2>&1 &
pid=$!
until [ "$(wc -l 2> /dev/null < "$work/k.csv.partial")" -ge 6 ] 2> /dev/null || ! kill -0 $pid; do
    sleep 0.01
done 2> /dev/null
kill -KILL $pid 2> /dev/null
wait $pid 2> /dev/null
head -n 5 "$work/k.csv.partial" | cmp -s - "$work/had"
ok $? 'of a result that was cut short the rows are kept' "$(head -c 300 "$work/k.csv.partial")"
loft sweep "$deck" -o "$work/k.csv" --resume
[ "$status" = 0 ] && cmp -s "$work/k.csv" "$work/a.csv"; ok $? 'and the rest is computed' "$(cat "$work/err")"
rm -f "$work"/k.*
loft sweep "$deck" -o "$work/k.csv" --resume
[ "$status" = 0 ] && cmp -s "$work/k.csv" "$work/a.csv"
ok $? 'resuming what was never begun begins it' "$(cat "$work/err")"
loft sweep "$deck" -o "$work/k.csv" --resume
[ "$status" = 0 ] && cmp -s "$work/k.csv" "$work/a.csv" && [ ! -e "$work/k.csv.partial" ]
ok $? 'resuming what is complete changes nothing' "$(cat "$work/err")"
loft sweep "$deck" --resume
said 2 'resume goes with -o FILE' '--resume needs a file'

# --- files that can't be written
loft sweep "$deck" -o /dev/full
said 2 '/dev/full: No space left on device' 'a full device'
loft sweep "$deck" -o "$work/no/such/folder.csv"
said 2 'folder.csv.partial: No such file or directory' 'no such folder, said at once'
loft sweep "$deck" -o "$deck"
said 2 'would replace the deck' 'the result may not replace the deck'
if [ "$(id -u)" != 0 ]; then
    mkdir "$work/locked" && chmod 555 "$work/locked"
    loft sweep "$deck" -o "$work/locked/a.csv"
    said 2 'a.csv.partial: Permission denied' 'a read-only folder, said at once'
fi
(ulimit -f 2; "$LOFT" sweep "$deck" -o "$work/full.csv" > /dev/null 2>&1); status=$?
[ "$status" != 0 ] && [ -s "$work/full.csv.partial" ] && [ ! -e "$work/full.csv" ]
ok $? 'a file that may not grow ends the sweep' "status $status"
loft sweep "$deck" -o "$work/full.csv" --resume
[ "$status" = 0 ] && cmp -s "$work/full.csv" "$work/a.csv"
ok $? 'and when there is room again it goes on'
mkfifo "$work/fifo"
cat "$work/fifo" > "$work/through" & loft sweep "$deck" -o "$work/fifo"; wait
sed '/^# [^l]/d; /^#  /d' "$work/through" | cmp -s - "$work/a.csv"; ok $? 'a FIFO is written through'
"$LOFT" sweep - < "$deck" > "$work/out"
sed '/^# [^l]/d; /^#  /d' "$work/out" | cmp -s - "$work/a.csv"; ok $? 'a deck from standard input'

# --- a terminal
if script -qec true /dev/null > /dev/null 2>&1; then
    sed 's/^SWEEP   LATIN   24/SWEEP   LATIN   9000/' "$deck" > "$work/long.crd"
    # Nothing in the first two seconds; stopped in the sixth.
    script -qec "timeout -s INT 6 '$LOFT' sweep '$work/long.crd' -o '$work/long.csv'" /dev/null > "$work/shown" < /dev/null
    tr '\r' '\n' < "$work/shown" | grep -c '^loft: variant [0-9]* of 9000, [0-9]* keep all limits, [0-9 hmins]* left' > "$work/lines"
    [ "$(cat "$work/lines")" -gt 0 ] && [ ! -e "$work/long.csv" ]
    ok $? 'a terminal shows how many are done, how many keep all limits, and the time left' "$(head -c 300 "$work/shown")"
    sound=$(grep -c ',ok,,' "$work/long.csv.partial")
    script -qec "timeout -s INT 5 '$LOFT' sweep '$work/long.crd' -o '$work/long.csv' --resume" /dev/null > "$work/shown" < /dev/null
    first=$(tr '\r' '\n' < "$work/shown" | sed -n 's/^loft: variant [0-9]* of 9000, \([0-9]*\) keep.*/\1/p' | head -n 1)
    [ "${first:-0}" -ge "$sound" ] && [ "$sound" -gt 0 ]
    ok $? 'those done before are among them' "first ${first:-none}, had $sound"
fi

# --- decks that can't be swept
refused() {
    printf '%s\n' "$2" > "$work/bad.crd"
    loft sweep "$work/bad.crd" -o "$work/bad.csv"
    said 1 "$1" "refused: $1"
}
refused 'no VARY card: nothing varies' "$(cat cards/nose.crd)"
refused 'no body deck' "$(cat cards/sae700202.crd)"
refused 'no OBJECT card' "$(grep -v '^OBJECT' "$deck")"
refused 'VOLUME has an aim already, MAX' "$(sed 's/^OBJECT  WETTED  MIN/OBJECT  VOLUME  MIN/' "$deck")"
refused 'FROM is above TO' "$(sed 's/BREADTH 10.5    13./BREADTH 13.     10.5/' "$deck")"
refused 'the card before has no field Y9' "$(sed 's/^VARY    Y2 /VARY    Y9 /' "$deck")"
refused 'there is no LINE MHX before; did you mean MHB' "$(sed 's/^END/OBJECT  JUMP    MIN             MHX/' "$deck")"
refused 'COUNT is 2 or more' "$(sed 's/-19.    -17.2/-19.    -17.2   0/' "$deck")"
refused 'the grid has 1000 x 1000 x 1000 = 1000000000 variants, more than 1000000' \
    "$(sed '/^SWEEP/d; s/10.5    13\./10.5    13.     1000/; s/-19.    -17.2/-19.    -17.2   1000/; s/-.46    -.36/-.46    -.36    1000/' "$deck")"
[ ! -e "$work/bad.csv" ] && [ ! -e "$work/bad.csv.partial" ]; ok $? 'nothing is left of them'
loft sweep "$work/nonexistent.crd"
said 2 'No such file or directory' 'no deck'
loft sweep "$work"
said 2 'Is a directory' 'a folder as deck'
loft sweep "$deck" --variant 61
said 2 'the sweep has variants 1 to 24' 'a variant beyond the last'
loft sweep
said 2 'loft sweep needs a deck' 'no deck is named'
loft sweep "$deck" "$deck"
said 2 'takes one deck' 'two decks'

# --- variants that fail are rows
sed 's/BREADTH 10.5    13\./BREADTH -5.     30./; s/^LIMIT.*/LIMIT   VOLUME  60000./' "$deck" > "$work/wild.crd"
loft sweep "$work/wild.crd" -o "$work/wild.csv"
[ "$(wc -l < "$work/wild.csv")" = 26 ] && grep -q ',fault,0,"line [0-9]*, columns' "$work/wild.csv" &&
    grep -q ',limit,0,"' "$work/wild.csv"
ok $? 'variants that can not be built are rows that say why' "$(cut -c1-100 "$work/wild.csv" | head -n 5)"
sed 's/^LIMIT.*/LIMIT   VOLUME  1.E9/' "$deck" > "$work/none.crd"
cp "$work/a.csv.best.crd" "$work/none.csv.best.crd"
loft sweep "$work/none.crd" -o "$work/none.csv"
[ "$status" = 1 ] && grep -q '^No variant keeps all limits' "$work/out" &&
    grep -q '^Variant 1: .*VOLUME .* is below 1.E+09' "$work/out"
ok $? 'no best where none keeps the limits: it is said why; status 1' "status $status $(cat "$work/out")"
[ ! -e "$work/none.csv.best.crd" ]; ok $? 'nor does the best of a sweep before stay'

# --- run and check take such a deck as it stands
loft run "$deck"
[ "$status" = 0 ] && [ ! -s "$work/err" ] && grep -q '^ *[0-9]*  VARY    TIED    Y2      LOW' "$work/out"
ok $? 'run echoes the cards of the sweep and runs the deck as it stands' "$(cat "$work/err")"
grep -v '^VARY\|^OBJECT\|^SWEEP\|^LIMIT' "$deck" > "$work/plain.crd"
"$LOFT" run --format csv "$deck" > "$work/with"; "$LOFT" run --format csv "$work/plain.crd" > "$work/without"
cmp -s "$work/with" "$work/without"; ok $? 'its points are those of the deck without them'

# --- the picture
if command -v gnuplot > /dev/null; then
    sed "s/^TITLE.*/TITLE   A \"\`touch $(basename "$work")\`\" \$(x) 'y' @z/" "$deck" > "$work/a b'c.crd"
    (cd "$work" && "$LOFT" sweep "a b'c.crd" -o plot.csv --plot > out 2> err); status=$?
    [ "$status" = 0 ] && grep -q '</svg>' "$work/a b'c-plots/front.svg"
    ok $? '--plot draws the front, whatever deck and title are called' "status $status $(cat "$work/err")"
    sed '/^LIMIT/d; /^CHECK/d; /^OBJECT  CLEAR/d' "$deck" > "$work/free.crd"
    (cd "$work" && "$LOFT" sweep free.crd -o free.csv --plot > out 2> err); status=$?
    [ "$status" = 0 ] && [ ! -s "$work/err" ] && grep -q "$(printf '^x_axis = .VOLUME MAX.')" "$work/free-plots/front.gp"
    ok $? 'without a word where no variant misses a limit' "status $status $(cat "$work/err")"
    awk -F, 'NR > 2 && $7 == "ok" { print $5, $6 }' "$work/free.csv" | sort > "$work/points"
    awk 'NF == 0 { exit } { print }' "$work/free-plots/front.dat" | sort | cmp -s - "$work/points"
    ok $? 'its points are those of the rows'
fi
finish
