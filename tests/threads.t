#!/bin/sh
# What runs in several threads at once has no variables in one place for all of them: neither its own
# nor those that gfortran makes for the length of a text of deferred length (`slen`, see
# src/base/text.f90). That is all that the library is made of, and what the program runs side by side:
# cards, sweeps and audits. Drawings, and rows and summaries of a sweep, are written by one thread.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh

objects=$(dirname "${LOFT:?}")
[ -d "$objects/release" ] && objects=$objects/release
if ! command -v nm > /dev/null || [ ! -d "$objects/src" ]; then
    echo '1..0 # SKIP nm and the objects of the build are needed'
    exit 0
fi

# Variables of objects. Tables of types, their first values, and jump tables are only read.
variables() {
    nm -A "$@" 2>&1 | awk '$2 ~ /^[bBdDC]$/ && $3 !~ /^__.*_MOD_?_?__(def_init|vtab)_|^__(def_init|vtab|copy)_|^A\.|^jumptable|^options\./
        !/:/ || /no symbols|No such/'
}
library=$(awk '$1 ~ /libloft\.o:$/ { print $2 }' "$objects/order.mk" | grep '\.o$' | sort -u)
[ "$(echo "$library" | wc -l)" -gt 200 ]
ok $? "the library has its objects: $(echo "$library" | wc -l)"
kept=$(variables $library)
[ -z "$kept" ]
ok $? 'no object of the library keeps anything between calls' "$kept"
beside=$(find src -name '*.f90' ! -path 'src/app/*' ! -path 'src/export/*' ! -path 'src/sweep/record.f90' \
    ! -path 'src/sweep/summary.f90' ! -path 'src/sweep/work.f90' | sed "s|\(.*\)\.f90|$objects/\1.o|")
kept=$(variables "$objects/src/app/run_card.o" $beside)
[ -z "$kept" ]
ok $? 'nor does what the program runs side by side' "$kept"
locked=$(nm -A -u $library | grep 'GOMP_critical')
[ -z "$locked" ]
ok $? 'no thread in the library waits for another' "$locked"

# Vectors of sines and the like are those of the C library, whose last digits depend on the processor.
vectors=$(find "$objects/src" -name '*.o' -exec nm -A -u {} + 2> /dev/null | grep ' _ZGV')
[ -z "$vectors" ]
ok $? 'the same deck gives the same digits on every processor: no vectors of sines' "$vectors"
finish
