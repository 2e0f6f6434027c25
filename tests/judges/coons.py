"""Judges patches of a STEP file of LOFT by OpenCASCADE: surfaces, their blends, points of cuts.

    coons.py FILE --points FILE.csv --unit MM --within D [--blend twist|flat|linear] [NAME...]

The surfaces are B-splines as OpenCASCADE reads them; what Coons' formulas make of their edges and
corner tangents is worked out here. NAME are patches; their points in the CSV file must lie on a
face. Prints the Test Anything Protocol; lengths of the command line are in the unit of the file.
"""
import argparse
import csv

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.gp import gp_Pnt, gp_Vec
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

from outlines import Tally


def faces_of(name):
    """The faces of a file, and its shape."""
    reader = STEPControl_Reader()
    reader.ReadFile(name)
    reader.TransferRoots()
    shape = reader.OneShape()
    found, explorer = [], TopExp_Explorer(shape, TopAbs_FACE)
    while explorer.More():
        found.append(TopoDS.Face(explorer.Current()))
        explorer.Next()
    return shape, found


def jet(surface, u, v):
    """A point of a surface and its first derivatives."""
    at, du, dv = gp_Pnt(), gp_Vec(), gp_Vec()
    surface.D1(u, v, at, du, dv)
    return [np.array([p.X(), p.Y(), p.Z()]) for p in (at, du, dv)]


def blends(kind, t):
    """F and G of both ends."""
    if kind == 'linear':
        return np.array([1 - t, t]), np.zeros(2)
    return (np.array([1 - 3 * t**2 + 2 * t**3, 3 * t**2 - 2 * t**3]),
            np.array([t - 2 * t**2 + t**3, -t**2 + t**3]))


def coons(surface, kind, u, v):
    """The Boolean sum of the edges of a surface, with cross slopes from its corners."""
    corner = np.array([[jet(surface, i, j) for j in (0, 1)] for i in (0, 1)])
    q, qu, qv = corner[:, :, 0], corner[:, :, 1], corner[:, :, 2]
    twist = np.zeros_like(q)
    if kind == 'twist':
        for i in (0, 1):
            for j in (0, 1):
                twist[i, j] = (qv[1, j] - qv[0, j] + qu[i, 1] - qu[i, 0]
                               - (q[1, 1] - q[0, 1] - q[1, 0] + q[0, 0]))
    fu, gu = blends(kind, u)
    fv, gv = blends(kind, v)
    point = np.zeros(3)
    for i in (0, 1):
        across = sum(fv[j] * qu[i, j] + gv[j] * twist[i, j] for j in (0, 1))
        point += fu[i] * jet(surface, i, v)[0] + gu[i] * across
        across = sum(fu[j] * qv[j, i] + gu[j] * twist[j, i] for j in (0, 1))
        point += fv[i] * jet(surface, u, i)[0] + gv[i] * across
        for j in (0, 1):
            point -= (fu[i] * fv[j] * q[i, j] + gu[i] * fv[j] * qu[i, j]
                      + fu[i] * gv[j] * qv[i, j] + gu[i] * gv[j] * twist[i, j])
    return point


def main():
    """Judges a file."""
    parser = argparse.ArgumentParser()
    parser.add_argument('file')
    parser.add_argument('names', nargs='+')
    parser.add_argument('--points', required=True)
    parser.add_argument('--unit', type=float, required=True)
    parser.add_argument('--within', type=float, required=True)
    parser.add_argument('--blend', default='twist', choices=['twist', 'flat', 'linear'])
    wanted = parser.parse_args()
    tally = Tally()
    shape, faces = faces_of(wanted.file)
    tally.ok(BRepCheck_Analyzer(shape).IsValid(), 'BRepCheck finds no fault')
    patches = [face for face in faces
               if (lambda s: s.UDegree() == 5 and s.VDegree() == 5)(BRep_Tool.Surface_s(face))]
    tally.ok(len(patches) == 2 * len(wanted.names), f'patches and images: {len(patches)}')
    for number, face in enumerate(patches):
        surface, off = BRep_Tool.Surface_s(face), 0.0
        for u in np.linspace(0, 1, 15):
            for v in np.linspace(0, 1, 15):
                off = max(off, np.linalg.norm(jet(surface, u, v)[0]
                                              - coons(surface, wanted.blend, u, v)))
        tally.ok(off <= 1e-9 * wanted.unit,
                 f'surface {number + 1} is the Coons patch of its edges, {wanted.blend}: {off:.1e}')
    with open(wanted.points, newline='') as file:
        rows = [row for row in csv.DictReader(file) if row['section'] in wanted.names]
    off = 0.0
    for row in rows:
        point = gp_Pnt(*(wanted.unit * float(row[axis]) for axis in ('sta', 'bl', 'wl')))
        vertex = BRepBuilderAPI_MakeVertex(point).Vertex()
        off = max(off, min(BRepExtrema_DistShapeShape(vertex, face).Value() for face in patches))
    tally.ok(len(rows) > 0 and off <= wanted.within * wanted.unit,
             f'{len(rows)} points of cuts lie on the patches: {off / wanted.unit:.1e}')
    tally.finish()


if __name__ == '__main__':
    main()
