#!/bin/sh
# Decks that once broke LOFT, and those that fuzzing starts from: each ends as it should.
# A line `* replay: COMMAND` in a deck is run besides; @ in it is a name in a scratch folder.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

# The run ended with 0, 1 or 2, said why, and the program was not at fault: judged PHRASE
judged() {
    case $status in
    0) ! grep -Eq '^[^ ].*: error: |^loft: ' "$work/err" ;;
    1) grep -q '^[^ ].*: error: ' "$work/err" ;;
    2) grep -q '^loft: ' "$work/err" && ! grep -q '^loft: out of memory, or at fault' "$work/err" ;;
    *) false ;;
    esac && ! grep -Eq 'runtime error|Sanitizer|^Backtrace|^At line' "$work/err" "$work/out" &&
        [ -z "$(find "$work" -name '*.part*')" ]
    ok $? "$1" "status $status, $(head -n 5 "$work/err")"
}

for deck in tests/fuzz/found/*.crd tests/fuzz/seeds/*.crd; do
    { echo 'run --format csv'; echo check; sed -n 's/^\* replay: //p' "$deck"; } | sort -u > "$work/commands"
    while read -r command; do
        (ulimit -t 60; eval "\"\${LOFT:?}\" $(echo "$command" | sed "s|@|$work/result|") \"$deck\"") \
            > "$work/out" 2> "$work/err" < /dev/null
        status=$?
        judged "loft $command $deck"
    done < "$work/commands"
done
finish
