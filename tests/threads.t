#!/bin/sh
# What runs in several threads at once has no variables in one place for all of them: neither its own
# nor those that gfortran makes for the length of a text (`slen`, see src/base/length.f90).
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh

objects=$(dirname "${LOFT:?}")
[ -d "$objects/release" ] && objects=$objects/release
if ! command -v nm > /dev/null || [ ! -d "$objects/src" ]; then
    echo '1..0 # SKIP nm and the objects of the build are needed'
    exit 0
fi
for object in "$objects"/src/geom/*.o "$objects"/src/body/*.o "$objects"/src/base/text.o \
    "$objects"/src/base/length.o "$objects"/src/base/list.o "$objects"/src/base/order.o \
    "$objects"/src/cut/*.o "$objects"/src/deck/conic_card.o "$objects"/src/deck/number.o \
    "$objects"/src/period/*.o "$objects"/src/report/card_block.o "$objects"/src/report/csv.o \
    "$objects"/src/report/row_text.o "$objects"/src/app/run_card.o "$objects"/src/base/digits.o \
    "$objects"/src/base/shortest.o "$objects"/src/base/fault.o "$objects"/src/base/column.o; do
    # Patches are built by one thread; a sweep has none.
    case $object in */build_sides.o) continue ;; esac
    nm "$object" 2> /dev/null | awk -v object="${object##*/src/}" \
        '$2 ~ /^[bBdDC]$/ && $3 !~ /^_?_(def_init|vtab|copy)|__def_init|__vtab|^options\.|jumptable/ { print object, $3 }'
done > /tmp/loft-threads.$$
[ ! -s /tmp/loft-threads.$$ ]
ok $? 'geometry, cuts, measures and cards keep nothing between calls' "$(cat /tmp/loft-threads.$$)"
rm -f /tmp/loft-threads.$$

# Vectors of sines and the like are those of the C library, whose last digits depend on the processor.
vectors=$(find "$objects/src" -name '*.o' -exec nm -A -u {} + 2> /dev/null | grep ' _ZGV')
[ -z "$vectors" ]
ok $? 'the same deck gives the same digits on every processor: no vectors of sines' "$vectors"
finish
