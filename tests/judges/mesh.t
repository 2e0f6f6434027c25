#!/bin/sh
# Meshes read by trimesh: watertight where the body is closed, turned outward, mirror-symmetric to
# the last bit, of the volume that the listing has.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

# A body as a mesh within a part of its size: meshed NAME FORMAT TOLERANCE OPTIONS...
meshed() {
    name=$1 ending=$2 tolerance=$3
    shift 3
    "${LOFT:?}" run "cards/$name.crd" > "$work/listing" 2> "$work/trouble"
    exported "$name.$ending" "cards/$name.crd" --tolerance "$tolerance" "$@"
    judge "$name as $ending" mesh.py "$work/$name.$ending" --symmetric \
        --volume "$(measure VOLUME "$work/listing")" --relative 3e-3
}
meshed fuselage obj .03
meshed ellipsoid stl .05 --binary
meshed sphere stl .05
meshed paraboloid obj .03
meshed cone stl .05 --binary
meshed round-nose obj .1
exported nose.stl cards/nose.crd
judge 'the nose, which is open' mesh.py "$work/nose.stl" --open --symmetric
exported open.stl cards/paraboloid.crd --open --binary
judge 'the paraboloid without caps' mesh.py "$work/open.stl" --open --symmetric
exported angle.obj cards/sphere.crd --tolerance 10 --angle 4
judge 'the sphere by angle alone' mesh.py "$work/angle.obj" --volume 523598.775598 --relative 5e-3 \
    --symmetric
finish
