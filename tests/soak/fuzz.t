#!/bin/sh
# Spoiled decks through three builds and the library for MINUTES, then faults of the system at many
# places. What is found is kept in build/soak: the deck, its command, what was wrong.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
build=${BUILD:-build}
cc -std=c99 -g -fsanitize=address,undefined -Isrc/api tests/fuzz/library.c "$build/sanitize/libloft.a" \
    -lgfortran -lgomp -llapack -lblas -lm -o "$build/sanitize/caller"
ok $? 'the caller of the library is built'
python3 -B tests/fuzz/fuzz.py --minutes "${MINUTES:-60}" --seed "${SEED:-1}" --keep "$build/soak" \
    --library "$build/sanitize/caller" \
    "$build/debug/loft" "$build/loft" "$build/sanitize/loft" > "$build/soak.log"
ok $? "no spoiled deck breaks LOFT (seed ${SEED:-1})" "$(cat "$build/soak.log")"
tail -n 1 "$build/soak.log"
FAULTS=60 sh tests/fuzz/faults.t > "$build/faults.log" 2>&1
ok $? 'no fault of the system does harm' "$(grep -A9 '^not ok' "$build/faults.log")"
tail -n 2 "$build/faults.log" | grep '^#'
finish
