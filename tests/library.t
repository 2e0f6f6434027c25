#!/bin/sh
# LOFT as a library: installed below a folder of its own, examples compiled and linked as a user does
# it and compared with the program, threads, bad arguments; then all of it removed again.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
: "${LOFT:?}"
case ${MODE:=release} in
release | debug) ;;
sanitize) echo '1..0 # SKIP a sanitizer stays out of shared libraries; tests/soak/leaks.t has the archive'; exit ;;
*) exit 1 ;;
esac
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
prefix=$folder/usr
build=${LOFT%/loft}
[ "$MODE" = debug ] && build=${build%/debug}
cc=${CC:-cc} cxx=${CXX:-c++} fc=${FC:-gfortran}
has() { command -v "$1" > /dev/null 2>&1; }

make MODE="$MODE" BUILD="$build" PREFIX="$prefix" install > "$folder/log" 2>&1
ok $? 'make install installs below PREFIX' "$(cat "$folder/log")"
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig" LD_LIBRARY_PATH="$prefix/lib"
if has pkg-config; then
    [ "loft $(pkg-config --modversion loft)" = "$("$LOFT" --version)" ]
    ok $? 'loft.pc has the version of the program'
    flags=$(pkg-config --cflags --libs loft)
    private=$(pkg-config --static --libs loft)
else
    flags="-I$prefix/include -I$(echo "$prefix"/include/loft/*) -L$prefix/lib -lloft"
    private='-llapack -lblas -lgfortran -lgomp -lm'
fi

# --- the shared library -----------------------------------------------------------------------------
so=$prefix/lib/libloft.so
abi=$(awk '$2 == "LOFT_ABI_VERSION" { print $3 }' src/api/loft.h)
objdump -p "$so" | grep -q "SONAME  *libloft.so.$abi\$"
ok $? 'the shared library is numbered as the interface of the header'
[ "$(readlink "$so")" = "libloft.so.$abi" ]
ok $? 'and libloft.so is a link to it'
shown=$(nm -D --defined-only "$so" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort)
strange=$(echo "$shown" | grep -v -e '^loft_' -e '^__api_loft_MOD_')
[ -n "$shown" ] && [ -z "$strange" ]
ok $? 'it shows loft_* and the module api_loft, nothing else' "$strange"
declared=$(sed -n 's/.*[ *]\(loft_[a-z_]*\)(.*/\1/p' src/api/loft.h | sort)
[ "$declared" = "$(echo "$shown" | grep '^loft_')" ]
ok $? 'each function of the header is there, and no other' "$declared"
strange=$(nm -g --defined-only "$prefix/lib/libloft.a" | awk 'NF == 3 { print $3 }' |
    grep -v -e '^loft_' -e '^__api_loft_MOD_' -e '^\.gomp_critical_user_')
[ -z "$strange" ]
ok $? 'the archive shows the same' "$strange"
strange=$(nm -u "$prefix/lib/libloft.a" |
    grep -E '_gfortran_(stop|error_stop|st_open|exit|system|abort)|\b(exit|abort|_exit|system|signal|getenv)\b')
[ -z "$strange" ]
ok $? 'nothing in it stops, exits, opens a unit, catches a signal or asks the environment' "$strange"

awk '/^ *enum loft_cause/, /};/' src/api/loft.h | sed -n 's/.*LOFT_\([A-Z_]*\) = \([0-9]*\).*/\1 \2/p' |
while read -r name number; do
    case $name in NO_ERROR) continue ;; BAD_ARGUMENT) name=USAGE ;; esac
    name=$(echo "$name" | tr '[:upper:]' '[:lower:]')
    grep -q "integer :: $name = $number " src/base/error.f90 || echo "$name = $number"
done > "$folder/causes"
[ ! -s "$folder/causes" ]
ok $? 'the causes of the header are those of base_error' "$(cat "$folder/causes")"

# --- the header -------------------------------------------------------------------------------------
strict='-Wall -Wextra -pedantic -Werror'
echo '#include <loft.h>' > "$folder/alone.c"
$cc -std=c99 $strict -I"$prefix/include" -fsyntax-only "$folder/alone.c" 2> "$folder/log"
ok $? 'the header alone is C99 without a warning' "$(cat "$folder/log")"
if has "$cxx"; then
    printf '#include <loft.h>\nint main() { return loft_abi_version() != LOFT_ABI_VERSION; }\n' \
        > "$folder/alone.cpp"
    { $cxx -std=c++11 $strict "$folder/alone.cpp" $flags -o "$folder/alone" && "$folder/alone"; } 2> "$folder/log"
    ok $? 'and C++, which links with it' "$(cat "$folder/log")"
fi

# --- the examples -----------------------------------------------------------------------------------
examples=$prefix/share/doc/loft/doc/examples
$cc -std=c99 $strict "$examples/plane.c" $flags -o "$folder/plane-c" 2> "$folder/log"
ok $? 'the example in C is compiled as pkg-config says' "$(cat "$folder/log")"
(cd "$folder" && $fc -std=f2018 -Wall "$examples/plane.f90" $flags -o plane-f) 2> "$folder/log"
ok $? 'so is the example in Fortran' "$(cat "$folder/log")"
archive="$prefix/lib/libloft.a $(echo "$private" | sed 's/-lloft//')"
$cc -std=c99 "$examples/plane.c" -I"$prefix/include" $archive -o "$folder/plane-static" 2> "$folder/log"
ok $? 'and in C with the archive' "$(cat "$folder/log")"
modules=$(echo "$prefix"/include/loft/*)
(cd "$folder" && $fc -std=f2018 "$examples/plane.f90" -I"$modules" $archive -o plane-f-static) 2> "$folder/log" &&
    ! ldd "$folder/plane-static" "$folder/plane-f-static" 2> /dev/null | grep -q libloft
ok $? 'and in Fortran, and neither needs the shared library' "$(cat "$folder/log")"

# The same cut by the program: cut, kind, then the columns of the examples.
plane() {
    { sed -e '/^STATION/,$d' -e '/^FLANGE/d' "cards/$1.crd"; echo "PLANE,$2"; echo END; } > "$folder/$1.crd"
    "$LOFT" run --format csv "$folder/$1.crd" | cut -d, -f3- > "$folder/want.csv"
    sed '/^STATION/,$d' "cards/$1.crd" > "$folder/$1-alone.crd"
    [ "$(wc -l < "$folder/want.csv")" -gt 20 ]
    ok $? "$1: the program cuts it"
    for program in plane-c plane-f plane-static plane-f-static; do
        "$folder/$program" "$folder/$1-alone.crd" $(echo "$2" | tr ',' ' ') > "$folder/got.csv" 2> "$folder/log"
        same "$folder/want.csv" "$folder/got.csv" > "$folder/difference"
        ok $? "$1: $program prints the same doubles" "$(cat "$folder/log"; head -5 "$folder/difference")"
    done
}
# Fields that are the same text or the same double.
same() {
    paste -d '|' "$1" "$2" | awk -F '|' '{
        n = split($1, a, ","); m = split($2, b, ",")
        for (i = 1; i <= n || i <= m; i++)
            if (a[i] != b[i] && (a[i] == "" || b[i] == "" || a[i] ~ /[A-Za-df-z]/ || a[i] + 0 != b[i] + 0))
                { print NR ": " $0; bad = 1; next }
    } END { exit bad }'
}
plane nose 10,0,-12,1,0,.5
plane fuselage 120,0,0,0,0,1
"$folder/plane-c" /no/such/deck 0 0 0 1 0 0 2>&1 | grep -q '^plane: /no/such/deck: No such file'
ok $? 'a deck that is not there is said'
"$folder/plane-c" cards/faults.crd 0 0 0 1 0 0 2> "$folder/faults" > /dev/null
[ "$(grep -c ': error: ' "$folder/faults")" = "$("$LOFT" check cards/faults.crd 2>&1 | grep -c ': error: ')" ]
ok $? 'a faulty deck has the errors that loft check says' "$(cat "$folder/faults")"

# --- all cuts and tables of the decks, against the program -------------------------------------------
$cc -std=c99 $strict tests/library/rows.c $flags -o "$folder/rows" 2> "$folder/log"
ok $? 'rows.c is compiled' "$(cat "$folder/log")"
for deck in cards/*.crd; do
    case $MODE$deck in debug*fuselage*) continue ;; esac    # minutes
    case $deck in cards/audit-*) continue ;; esac           # of printed tables, not of the library
    "$folder/rows" "$deck" > "$folder/got.csv"
    "$LOFT" run --format csv "$deck" 2> "$folder/log" | tail -n +2 > "$folder/want.csv"
    same "$folder/want.csv" "$folder/got.csv" > "$folder/difference"
    ok $? "$deck: the rows are those of loft run --format csv" "$(head -3 "$folder/difference")"
done

# --- careless callers and threads -------------------------------------------------------------------
$cc -std=c99 -O1 $strict tests/library/abuse.c $flags -lm -o "$folder/abuse" 2> "$folder/log"
ok $? 'abuse.c is compiled' "$(cat "$folder/log")"
version=$("$LOFT" --version)
(cd "$folder" && ./abuse "$ROOT" "${version#loft }") > "$folder/log" 2>&1
ok $? "careless calls do no harm: $(grep -c '^ok' "$folder/log") checks" "$(grep -v '^ok' "$folder/log")"
$cc -std=c99 -O1 $strict tests/library/threads.c $flags -lpthread -o "$folder/threads" 2> "$folder/log"
ok $? 'threads.c is compiled' "$(cat "$folder/log")"
decks='cards/nose.crd cards/batten.crd cards/faults.crd cards/sae700202.crd cards/inlet.crd cards/faired.crd
    cards/duct.crd'
"$folder/threads" "$([ "$MODE" = debug ] && echo 1 || echo 4)" $decks > "$folder/log" 2>&1
ok $? 'eight threads get what one gets' "$(cat "$folder/log")"
if has valgrind && [ "$MODE" = release ]; then
    (cd "$folder" && valgrind -q --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite,indirect \
        ./abuse "$ROOT" "${version#loft }") > "$folder/log" 2>&1
    ok $? 'valgrind finds no bad access and no leak in careless calls' "$(grep -v '^ok' "$folder/log" | head -40)"
    valgrind -q --tool=helgrind --error-exitcode=9 "$folder/threads" 1 cards/batten.crd cards/faults.crd \
        cards/sae700202.crd > "$folder/log" 2>&1
    ok $? 'helgrind finds no race between eight threads' "$(head -40 "$folder/log")"
fi

# --- DESTDIR, a foreign folder, and gone again --------------------------------------------------------
make MODE="$MODE" BUILD="$build" PREFIX=/opt/loft DESTDIR="$folder/stage" install > "$folder/log" 2>&1 &&
    [ -x "$folder/stage/opt/loft/bin/loft" ] && [ -f "$folder/stage/opt/loft/lib/libloft.so.$abi" ] &&
    grep -q '^prefix=/opt/loft$' "$folder/stage/opt/loft/lib/pkgconfig/loft.pc"
ok $? 'DESTDIR stands before PREFIX, and loft.pc does not know of it' "$(tail -3 "$folder/log")"
if has pkg-config; then
    staged=$(PKG_CONFIG_PATH="$folder/stage/opt/loft/lib/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$folder/stage" \
        pkg-config --cflags --libs loft)
    "$folder/plane-static" "$folder/fuselage-alone.crd" 120 0 0 0 0 1 > "$folder/want.csv"
    $cc -std=c99 "$folder/stage/opt/loft/share/doc/loft/doc/examples/plane.c" $staged -o "$folder/plane-staged" \
        2> "$folder/log" && LD_LIBRARY_PATH=$folder/stage/opt/loft/lib \
        "$folder/plane-staged" "$folder/fuselage-alone.crd" 120 0 0 0 0 1 > "$folder/got.csv" 2>> "$folder/log" &&
        same "$folder/want.csv" "$folder/got.csv" > "$folder/difference"
    ok $? 'what is staged there is compiled with and runs' "$(cat "$folder/log"; head -5 "$folder/difference")"
fi
make MODE="$MODE" BUILD="$build" PREFIX=/opt/loft DESTDIR="$folder/stage" uninstall > "$folder/log" 2>&1
left=$(cd "$folder/stage" && find . ! -type d)
[ -z "$left" ]
ok $? 'and is taken away again' "$left $(cat "$folder/log")"
mkdir "$folder/else where" && cd "$folder/else where" || exit 1
"$prefix/bin/loft" run "$prefix/share/loft/cards/nose.crd" -o nose.lst && [ -s nose.lst ]
ok $? 'the installed program runs a deck from another folder'
"$prefix/bin/loft" export "$prefix/share/loft/cards/nose.crd" -o nose.step > log 2>&1 && [ -s nose.step.receipt ]
ok $? 'and exports one' "$(cat log)"
if has gnuplot; then
    "$prefix/bin/loft" plot "$prefix/share/loft/cards/nose.crd" -o plots > log 2>&1 && [ -s plots/lines.svg ]
    ok $? 'and finds its gnuplot scripts' "$(cat log; ls plots)"
fi
cd "$ROOT" || exit 1
touch "$prefix/share/doc/another" "$prefix/lib/another"
make MODE="$MODE" BUILD="$build" PREFIX="$prefix" uninstall > "$folder/log" 2>&1
left=$(cd "$prefix" && find . ! -type d -o -name '*loft*' | sort | tr '\n' ' ')
[ "$left" = './lib/another ./share/doc/another ' ]
ok $? 'make uninstall removes what was installed and nothing else' "$left $(cat "$folder/log")"

finish
