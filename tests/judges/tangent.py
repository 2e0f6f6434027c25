"""Judges by OpenCASCADE whether patches of a STEP file are tangent to what lies beside them.

    tangent.py FILE --degrees D --sides N

Each edge of a patch (a face of degree 5 along u and v) is followed in 101 points; where all of them
lie on another face, the normals of both are compared there. N edges of starboard and port patches
must lie on others within 1e-6 of the patch, with normals within D degrees. Prints the Test Anything
Protocol.
"""
import argparse

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.GeomAPI import GeomAPI_ProjectPointOnSurf
from OCP.gp import gp_Pnt

from coons import faces_of, jet
from outlines import Tally


def normal(surface, u, v):
    """The unit normal of a surface, or None where it has none."""
    _, du, dv = jet(surface, u, v)
    cross = np.cross(du, dv)
    size = np.linalg.norm(cross)
    return None if size <= 1e-9 * max(du @ du, dv @ dv) else cross / size


def side(number, t):
    """The parameters of a place on an edge."""
    return [(t, 0.0), (1.0, t), (1.0 - t, 1.0), (0.0, 1.0 - t)][number]


def compare(surface, number, other):
    """The largest distance from the other face and the largest angle; None where it is far off."""
    worst_off, worst_angle, size = 0.0, 0.0, 0.0
    for t in np.linspace(0.0, 1.0, 101):
        at = jet(surface, *side(number, t))[0]
        size = max(size, np.linalg.norm(at - jet(surface, *side(number, 0.0))[0]))
        own = normal(surface, *side(number, t))
        foot = GeomAPI_ProjectPointOnSurf(gp_Pnt(*at), other)
        if foot.NbPoints() == 0:
            return None
        off = foot.LowerDistance()
        if off > 1e-3:
            return None
        worst_off = max(worst_off, off)
        beside = normal(other, *foot.LowerDistanceParameters())
        if own is None or beside is None:
            continue
        worst_angle = max(worst_angle, np.degrees(np.arcsin(min(1.0, np.linalg.norm(
            np.cross(own, beside))))))
    return None if size < 1e-6 else (worst_off / size, worst_angle)


def main():
    """Judges a file."""
    parser = argparse.ArgumentParser()
    parser.add_argument('file')
    parser.add_argument('--degrees', type=float, required=True)
    parser.add_argument('--sides', type=int, required=True)
    wanted = parser.parse_args()
    tally = Tally()
    _, faces = faces_of(wanted.file)
    surfaces = [BRep_Tool.Surface_s(face) for face in faces]
    patches = [s for s in surfaces
               if hasattr(s, 'UDegree') and (s.UDegree(), s.VDegree()) == (5, 5)]
    met, off, angle = 0, 0.0, 0.0
    for patch in patches:
        for number in range(4):
            found = [compare(patch, number, s) for s in surfaces if s is not patch]
            found = [pair for pair in found if pair]
            if not found:
                continue
            best = min(found, key=lambda pair: pair[1])
            met, off, angle = met + 1, max(off, best[0]), max(angle, best[1])
    tally.ok(met == wanted.sides, f'{met} edges of patches lie on other faces')
    tally.ok(off <= 1e-6, f'they do so within {off:.1e} of their size')
    tally.ok(angle <= wanted.degrees, f'and their normals agree within {angle:.1e} degrees')
    tally.finish()


if __name__ == '__main__':
    main()
