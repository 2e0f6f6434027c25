#!/bin/sh
# The command line as a whole: help, version, what is misused, which exit status.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
deck=cards/sae700202.crd

# Runs LOFT, keeps output, messages and status.
loft() {
    "${LOFT:?}" "$@" > "$work/out" 2> "$work/err" < /dev/null
    status=$?
}

# The command line is refused: refused 'words of the message' ARGUMENTS...
refused() {
    words=$1; shift
    loft "$@"
    [ "$status" = 2 ] && [ ! -s "$work/out" ] && [ "$(wc -l < "$work/err")" = 1 ] &&
        grep -q '^loft: ' "$work/err" && grep -qF -- "$words" "$work/err"
    ok $? "refused: loft $*" "status $status, $(cat "$work/err")"
}

loft --version
[ "$status" = 0 ] && grep -q '^loft [0-9][0-9.]*$' "$work/out" && [ ! -s "$work/err" ]
ok $? '--version prints name and version alone' "$(cat "$work/out")"
sed -n "s/.*version = '\(.*\)'.*/loft \1/p" src/base/constants.f90 | cmp -s - "$work/out"
ok $? 'the version is that of base_constants'

for command in help --help -h; do
    loft "$command"
    [ "$status" = 0 ] && grep -q 'loft run' "$work/out" && [ ! -s "$work/err" ]
    ok $? "loft $command gives the overview"
done
for topic in run check plot export; do
    loft help "$topic"
    [ "$status" = 0 ] && [ -s "$work/out" ] && ! grep -q '.\{81\}' "$work/out"
    ok $? "loft help $topic answers within 80 columns"
done
for command in run check plot export; do
    "$LOFT" help "$command" > "$work/topic"
    loft "$command" --help
    [ "$status" = 0 ] && cmp -s "$work/out" "$work/topic"
    ok $? "loft $command --help is loft help $command"
    # Every option that the reader of the command line knows for this command is in its help.
    sed -e ':a' -e '/&$/N' -e 's/ &\n */ /' -e 'ta' src/app/option_table.f90 | tr '(' '\n' |
        sed -n "s/^\('[^']*', '[^']*', '[^']*', '[^']*'\), .*/\1/p" | sed "s/', '/|/g; s/'//g" |
        grep "|\([^|]* \)*$command\( [^|]*\)*$" > "$work/known"
    [ "$command" = check ] || [ "$(wc -l < "$work/known")" -gt 1 ]
    ok $? "the options of loft $command are found in the source" "$(cat "$work/known")"
    while IFS='|' read -r option kind words commands; do
        [ "$option" = --help ] && continue
        grep -q -- "$option" "$work/topic"
        ok $? "loft help $command tells of $option"
        [ "$kind" = words ] || [ "$kind" = paper ] || continue
        for word in $words; do
            grep -qw -- "$word" "$work/topic"
            ok $? "loft help $command tells of $option $word"
        done
    done < "$work/known"
done
loft help cards
for field in X1 Y1 S1 X2 Y2 X3 Y3 S3 XI YI ITYP TITLE UNITS; do
    grep -qw "$field" "$work/out"
    ok $? "loft help cards tells of $field"
done

refused 'no command'
refused "'draw' is no command" draw $deck
refused 'has no option --colour' run --colour $deck
refused 'has no option -x' run -x $deck
refused 'needs a value' run $deck -o
refused 'needs a value' run $deck --arithmetic
refused 'ieee s360' run --arithmetic vax $deck
refused 'listing csv' run --format pdf $deck
refused 'svg pdf png txt' plot --format csv $deck
refused 'number' run --arithmetic s360 --shift ten $deck
refused 'number' run --arithmetic s360 --shift= $deck
refused '-o is given twice' run $deck -o "$work/one" -o "$work/two"
refused 'takes no value' run --asa=yes --arithmetic s360 $deck
refused '--asa goes with' run --asa $deck
refused '--format csv goes with' run --arithmetic s360 --format csv $deck
refused 'takes one deck' run $deck $deck
refused 'needs a deck' check
refused 'needs a deck' plot
refused 'no help on' help lofting
refused 'takes one topic' help run check
refused 'stands alone' --version now
refused 'would replace the deck' run -o $deck $deck
refused 'no option' check --asa $deck
refused 'would replace the deck' run -o cards/../$deck $deck
cp $deck "$work/deck" && ln -s deck "$work/link"
refused 'would replace the deck' run -o "$work/link" "$work/deck"
refused 'would replace the deck' run -o "$work/deck" "$work/link"
cmp -s $deck "$work/deck"
ok $? 'the deck that -o named is still there'

loft run --arithmetic s360 $deck
cp "$work/out" "$work/plain"
loft run --arithmetic=s360 --shift=100 -- $deck
[ "$status" = 0 ] && cmp -s "$work/out" "$work/plain"
ok $? 'an option takes its value behind an equals sign, -- ends the options'
loft run $deck --arithmetic ieee --arithmetic s360
[ "$status" = 0 ] && cmp -s "$work/out" "$work/plain"
ok $? 'options may follow the deck; the last of a kind counts'
loft run --arithmetic s360 --shift 200 $deck
[ "$status" = 0 ] && ! cmp -s "$work/out" "$work/plain" && [ "$(wc -l < "$work/out")" = "$(wc -l < "$work/plain")" ]
ok $? '--shift moves the coefficients of the 1970 program'
(cd "$work" && cp "$ROOT/$deck" ./-deck.crd && "$LOFT" run --arithmetic s360 -- -deck.crd) | cmp -s - "$work/plain"
ok $? 'a deck behind -- may begin with a dash'
odd="$work/my deck's \"best\" nose.crd"
cp $deck "$odd"
loft run --arithmetic s360 "$odd"
[ "$status" = 0 ] && cmp -s "$work/out" "$work/plain"
ok $? 'the name of a deck may have blanks and quotes'
printf 'x' >> "$odd" && printf 'O.      0.\n' > "$odd"
loft check "$odd"
[ "$status" = 1 ] && head -n 1 "$work/err" | grep -qF "$odd:1:1-1: error: X1: "
ok $? 'the name stands in the diagnostics as it was given' "$(cat "$work/err")"

loft help station
[ "$status" = 0 ] && head -n 1 "$work/out" | grep -q '^STATION: '
ok $? 'help on one card'
loft run $deck -o "$work/table.csv"
[ "$status" = 0 ] && grep -q 'table.csv gets a listing; --format csv' "$work/err"
ok $? 'a listing into a file of comma-separated values is remarked on'
loft run --format CSV $deck -o "$work/table.csv"
[ "$status" = 0 ] && [ ! -s "$work/err" ] && head -n 1 "$work/table.csv" | grep -q '^card,axis,x,y'
ok $? '--format csv in capitals'

loft check $deck
[ "$status" = 0 ] && [ ! -s "$work/out" ] && [ ! -s "$work/err" ]
ok $? 'check says nothing of a sound deck and ends with 0'
loft check $deck cards/faults.crd
[ "$status" = 1 ] && [ ! -s "$work/out" ] && grep -q '^cards/faults.crd:4:1-5: error: ' "$work/err"
ok $? 'check reads all decks it is given; one at fault makes the status 1'
loft check "$work/none" cards/faults.crd
[ "$status" = 2 ] && grep -q '^cards/faults.crd:4:1-5: error: ' "$work/err" && grep -qF "$work/none: No such file" "$work/err"
ok $? 'a deck that is not there makes the status 2; the others are still checked' "$(head -n 2 "$work/err")"
finish
