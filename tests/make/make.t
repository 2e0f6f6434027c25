#!/bin/sh
# The scripts behind the Makefile, on a small tree: order of compilation, picture.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
scripts=$PWD/tests/make
tree=$(mktemp -d) && trap 'rm -rf "$tree"' EXIT
cd "$tree" || exit 1
mkdir -p src/base src/geom src/deck src/app tests/geom

printf 'module base_kinds\nend module base_kinds\n' > src/base/kinds.f90
printf 'module geom_arc\n use, intrinsic :: iso_c_binding, only: c_int\n use base_kinds, only: dp\n' > src/geom/arc.f90
printf 'module deck_card\n use :: base_kinds, only: dp\n' > src/deck/card.f90
printf 'program loft\n  USE geom_arc, only: x\n  use_of = 1\n' > src/app/main.f90
printf 'program test_arc\n use geom_arc, only: x\n' > tests/geom/test_arc.f90

order() {
    awk -v objects=o -v loft=bin/loft -v library=lib.o -f "$scripts/modules.awk" -f "$scripts/order.awk" \
        $(find src tests -name '*.f90' | sort) | sort
}
picture() {
    awk -f "$scripts/modules.awk" -f "$scripts/graph.awk" $(find src -name '*.f90' | sort)
}

want='bin/loft: o/src/app/main.o
bin/loft: o/src/base/kinds.o
bin/loft: o/src/geom/arc.o
o/src/app/main.o: o/src/geom/arc.o
o/src/deck/card.o: o/src/base/kinds.o
o/src/geom/arc.o: o/src/base/kinds.o
o/tests/geom/test_arc.o: o/src/geom/arc.o
o/tests/geom/test_arc: o/src/base/kinds.o
o/tests/geom/test_arc: o/src/geom/arc.o
o/tests/geom/test_arc: o/tests/geom/test_arc.o'
want=$(echo "$want" | sort)
[ "$(order)" = "$want" ]
ok $? 'objects wait for what they use, programs are linked from what they need' "$(order)"

mkdir -p mpi/geom
printf 'module geom_arc\n use mpi_f08, only: mpi_init\n' > mpi/geom/arc.f90
twins() {
    awk -v objects=o -v loft=bin/loft -v twins=mpi/geom/arc.f90 -f "$scripts/modules.awk" \
        -f "$scripts/order.awk" $(find src tests -name '*.f90' | sort) | sort
}
[ "$(twins | sed -n 's/^bin.loft-mpi: //p' | tr '\n' ' ')" = \
    'o/mpi/geom/arc.o o/src/app/main.o o/src/base/kinds.o ' ]
ok $? 'loft-mpi is linked with the twin of a module' "$(twins)"
[ "$(twins | grep -v '^bin/loft-mpi')" = "$want" ]
ok $? 'and nothing else changes by it' "$(twins)"
rm -r mpi

mkdir src/api
printf 'module api_loft\n use geom_arc, only: x\n' > src/api/loft.f90
printf 'module api_c_deck\n use api_loft, only: x\n' > src/api/c_deck.f90
printf 'module api_inner\n use deck_card, only: x\n' > src/api/inner.f90
[ "$(order | sed -n 's/^lib.o: //p' | sort -u | tr '\n' ' ')" = \
    'o/src/api/c_deck.o o/src/api/loft.o o/src/base/kinds.o o/src/geom/arc.o ' ]
ok $? 'the library is made of its faces and what they need' "$(order)"
rm -r src/api

picture | grep -q 'geom_arc \[label="arc\\n3"\]'
ok $? 'a box has the name and the lines of its module'
[ "$(picture | grep -c '^    subgraph cluster_')" = 4 ]
ok $? 'a band is drawn for each layer there is'
[ "$(picture | grep -n 'subgraph' | sed 's/.*cluster_\([a-z]*\).*/\1/' | tr '\n' ' ')" = 'app deck geom base ' ]
ok $? 'the bands stand in the order of the layers'
! picture | grep -q 'color=red'
ok $? 'no arrow is red where all go down'

printf ' use deck_card, only: y\n' >> src/geom/arc.f90
picture | grep -q 'geom_arc -> deck_card \[color=red'
ok $? 'an arrow against the layers is red'

printf ' use base_gone, only: y\n' >> src/geom/arc.f90
order | grep -q '^o/src/geom/arc.o: o/no-such-module/base_gone.o$'
ok $? 'a module that is not there is asked of make by name'

printf 'module deck_card\n use geom_arc, only: x\n' > src/deck/card.f90
order > /dev/null
ok $? 'modules that use each other do not hang the script'

# Rows of a layer and what it uses, as the scripts have them and as a page has them.
cat > ruled.awk << 'END'
BEGIN {
    n = split(layers, layer, " ")
    for (i = 1; i <= n; i++) print layer[i], i == 1 ? "nothing" : \
        i == n ? "all" : i == n - 1 ? "all but " layer[n] : below[layer[i]]
}
END
ruled() { awk -f "$scripts/modules.awk" -f ruled.awk; }
told() { sed -n 's/^| `\([a-z]*\)` *|.*| *\(.*[^ ]\) *|$/\1 \2/p' "$1"; }
[ "$(told "$ROOT/doc/architecture.md")" = "$(ruled)" ]
ok $? 'doc/architecture.md tells of all layers, and what each may use' "$(ruled)"
[ "$(sed -n 's/^| `\([a-z]*\)` .*/\1/p' "$ROOT/doc/ford.md")" = "$(ruled | sed 's/ .*//')" ]
ok $? 'so do the pages made of the docstrings'

finish
