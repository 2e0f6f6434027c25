#!/bin/sh
# A module of mpi/ and the one of src/ it stands for have one interface: users of the module are
# compiled against one of them and may be linked with the other.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh

# What users see of a module: its public names, its types, its procedures with their arguments.
interface_of() {
    awk '/^ *public ::/ { print }
         /^ *type ::/, /^ *end type/ { print }
         /^ *(pure |elemental |logical |integer )*(subroutine|function) / { print }
         /intent\(/ { print }' "$1" | sed 's/ *!!.*//'
}

twins=$(find mpi -name '*.f90')
[ -n "$twins" ]; ok $? 'there are twins'
for twin in $twins; do
    other=src/${twin#mpi/}
    [ -n "$(interface_of "$twin")" ] && [ "$(interface_of "$twin")" = "$(interface_of "$other")" ]
    ok $? "$twin has the interface of $other" "$(interface_of "$twin")
---
$(interface_of "$other")"
done
finish
