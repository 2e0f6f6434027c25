#!/bin/sh
# Patches that are TANGENT, as OpenCASCADE reads them, and a mesh closed over patches and sections,
# as trimesh does.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

exported hatch.step cards/hatch.crd --tolerance 1e-5
judge 'a hatch in the skin' tangent.py "$work/hatch.step" --degrees .01 --sides 8
exported nose-cap.step cards/nose-cap.crd --tolerance 1e-5
judge 'a nose cap' tangent.py "$work/nose-cap.step" --degrees .01 --sides 12
exported nose-cap.stl cards/nose-cap.crd
judge 'the nose cap on its body' mesh.py "$work/nose-cap.stl" --symmetric
finish
