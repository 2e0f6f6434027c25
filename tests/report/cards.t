#!/bin/sh
# The card reference of the documentation is what `loft help cards` prints.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

"${LOFT:?}" help cards > "$work/printed"
ok $? 'loft help cards is there'
sed -n '/^<!-- loft help cards -->$/,/^<!-- end -->$/p' doc/cards.md | sed '1,2d;$d' | sed '$d' > "$work/written"
[ -s "$work/written" ] && cmp -s "$work/printed" "$work/written"
ok $? 'doc/cards.md says the same' "$(diff "$work/printed" "$work/written" | head -n 10)"
finish
