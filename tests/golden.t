#!/bin/sh
# Compares every golden file byte for byte with what the program prints now.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
. tests/support/golden.sh
new=$(mktemp) && trap 'rm -f "$new"' EXIT

# True for files whose last digits depend on how LOFT is compiled: bevels of oblique cuts of the
# fuselage, points of equal lengths on patches with tangent sides. The debug build must run them.
differs_by_build() {
    case $LOFT:$1 in
    */debug/loft:golden/fuselage.* | */debug/loft:golden/hatch.* | */debug/loft:golden/nose-cap.*) ;;
    *) return 1 ;;
    esac
}

[ -n "$(golden_files)" ]; ok $? 'there are golden files'
for file in $(golden_files); do
    golden_output "$file" > "$new"
    status=$?
    if differs_by_build "$file"; then
        [ "$status" -le 1 ] && [ "$(wc -l < "$new")" = "$(wc -l < "$file")" ]
        ok $? "$file: LOFT prints as many lines" "status $status"
        continue
    fi
    [ "$status" -le 1 ] && [ -s "$file" ] && cmp -s "$new" "$file"
    ok $? "$file is what LOFT prints" "status $status
$(diff "$file" "$new" | head -n 10)"
done
finish
