#!/bin/sh
# A 1970 deck is streamed: faults are reported as they are met, and memory does not grow with it.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
mkfifo "$work/slow"

# Waits until a file has some words, five seconds at most.
comes() {
    waited=0
    until grep -qs -- "$1" "$2" || [ $waited -ge 100 ]; do sleep 0.05; waited=$((waited + 1)); done
    grep -qs -- "$1" "$2"
}

for command in 'run --format csv' 'run --arithmetic s360' check; do
    "${LOFT:?}" $command "$work/slow" > "$work/out" 2> "$work/err" &
    run=$!
    exec 3> "$work/slow"
    printf '%s\n' '-30.    -10.    .114    0.      -7.1    5O.     -4.     .0523   5.' >&3
    comes ':1:42-42: error: X3: the letter O' "$work/err"
    ok $? "loft $command reports a fault while the deck still arrives" "$(cat "$work/err")"
    printf '%s\n' '-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.,' >&3
    comes ':2:67-67: error: XI: a comma' "$work/err"
    ok $? "loft $command goes on to the next" "$(cat "$work/err")"
    exec 3>&-
    wait $run
    [ $? = 1 ]
    ok $? "loft $command ends with status 1 when the deck ends"
done

# Many cards, many faults, one endless line, in little memory.
limit=98304
(ulimit -v $limit && "$LOFT" --version > /dev/null 2>&1) || limit=
[ -n "$limit" ] || limit_words=' # SKIP memory cannot be limited here'
within() { (ulimit -v ${limit:-unlimited}; "$LOFT" "$@"); }
cards() {
    awk -v n="$1" -v card="$2" 'BEGIN { for (i = 1; i <= n; i++) print card }'
}
good='-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   50.'
bad='-30.    -10.    .114    0.      -7.1    5O.     -4.     .0523   50.'
count=200000
cards $count "$good" | within run --format csv > "$work/out" 2> "$work/err"
[ $? = 0 ] && [ ! -s "$work/err" ] && tail -n 1 "$work/out" | grep -q "^$count,X,50,-4,"
ok $? "$count cards as CSV in a small memory$limit_words" "$(tail -n 2 "$work/out" "$work/err")"
cards 20000 "$good" | within run > "$work/out" 2> "$work/err"
[ $? = 0 ] && grep -q '^CARD 20000 ' "$work/out"
ok $? "20000 cards as a listing in a small memory$limit_words" "$(tail -n 2 "$work/out" "$work/err")"
cards $count "$bad" | within check - > "$work/out" 2> "$work/err"
[ $? = 1 ] && [ "$(grep -c ': error: ' "$work/err")" = $count ]
ok $? "$count bad cards in a small memory$limit_words" "$(tail -n 2 "$work/err")"
head -c 200000000 /dev/zero | tr '\0' ' ' | within check - > "$work/out" 2> "$work/err"
[ $? = 1 ] && grep -q 'no conic card' "$work/err"
ok $? "a line of 200 million blanks in a small memory$limit_words" "$(head -c 300 "$work/err")"
(echo "$good"; echo 999.99; cards $count "$good") | within run --format csv > "$work/out" 2> "$work/err"
[ $? = 0 ] && grep -q "2: warning: $count cards after the end card not read" "$work/err"
ok $? "$count cards behind the end card are counted$limit_words" "$(tail -n 2 "$work/err")"
finish
