#!/bin/sh
# Compares every golden file byte for byte with what the program prints now.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
. tests/support/golden.sh
new=$(mktemp) && trap 'rm -f "$new"' EXIT

[ -n "$(golden_files)" ]; ok $? 'there are golden files'
for file in $(golden_files); do
    golden_output "$file" > "$new"
    status=$?
    [ "$status" -le 1 ] && [ -s "$file" ] && cmp -s "$new" "$file"
    ok $? "$file is what LOFT prints" "status $status
$(diff "$file" "$new" | head -n 10)"
done
finish
