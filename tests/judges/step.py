"""Judges a STEP file of LOFT by OpenCASCADE: what it reads, measures and cuts.

    step.py FILE [--unit MM] [--solids N] [--area A] [--points FILE.csv --within D] ...

Prints the Test Anything Protocol; ends with status 1 where a check fails. All lengths of the
command line are in the unit of the file, of which --unit says how many millimetres it has:
OpenCASCADE reads into millimetres, so that a wrong unit of the file is seen.
"""
import argparse
import csv

import numpy as np
from OCP.BRep import BRep_Builder, BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepAlgoAPI import BRepAlgoAPI_Section
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepGProp import BRepGProp
from OCP.GeomAbs import GeomAbs_Plane
from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_RetDone
from OCP.ShapeAnalysis import ShapeAnalysis_ShapeTolerance
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_COMPOUND, TopAbs_EDGE, TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Compound, TopoDS_Iterator

from outlines import Tally

KINDS = {'solids': TopAbs_SOLID, 'shells': TopAbs_SHELL, 'faces': TopAbs_FACE}


def parts(shape, kind):
    """The shapes of a kind, once for each time they are used."""
    found, explorer = [], TopExp_Explorer(shape, kind)
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def compound(shapes):
    """Shapes as one."""
    builder, whole = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(whole)
    for shape in shapes:
        builder.Add(whole, shape)
    return whole


def area(faces):
    """Area of faces, square millimetres."""
    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(compound(faces), properties, 1e-10)
    return properties.Mass()


def volume(solids):
    """Volume of solids, cubic millimetres."""
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(compound(solids), properties, 1e-10, False)
    return properties.Mass()


def is_flat(face):
    """True for a face of a plane."""
    return BRepAdaptor_Surface(TopoDS.Face(face)).GetType() == GeomAbs_Plane


def free_edges(shell):
    """Edges that only one face of a shell uses; an edge shrunk to a point is none."""
    edges = [edge for edge in parts(shell, TopAbs_EDGE)
             if not BRep_Tool.Degenerated_s(TopoDS.Edge(edge))]
    return [edge for edge in edges if sum(edge.IsSame(other) for other in edges) == 1]


def read_csv(name):
    """Points and bevels of each cut of a table of `loft run --format csv`, in its unit."""
    cuts = {}
    with open(name, encoding='latin-1') as file:
        for row in csv.DictReader(file):
            numbers = [float(row[column] or 0) for column in ('sta', 'bl', 'wl', 'bevel')]
            cuts.setdefault(int(row['cut']), []).append(numbers)
    return {cut: np.array(cuts[cut]) for cut in sorted(cuts)}


def children(shape):
    """What a compound is made of."""
    found, iterator = [], TopoDS_Iterator(shape)
    while iterator.More():
        found.append(iterator.Value())
        iterator.Next()
    return found


def curve_sets(shape):
    """The compounds that are of no others, in order: one for each set of curves."""
    groups = [part for part in children(shape) if part.ShapeType() == TopAbs_COMPOUND]
    if shape.ShapeType() == TopAbs_COMPOUND and not groups:
        return [shape]
    return [found for group in groups for found in curve_sets(group)]


def complaints(reader):
    """What the reader finds wrong with the file, or could not make a shape of."""
    process = reader.WS().TransferReader().TransientProcess()
    return listed(reader.WS().ModelCheckList()) + listed(process.CheckList(False))


def listed(checks):
    """Fails and warnings of a list of checks."""
    found = []
    checks.Start()
    while checks.More():
        check = checks.Value()
        found += [check.CFail(i + 1) for i in range(check.NbFails())]
        found += [check.CWarning(i + 1) for i in range(check.NbWarnings())]
        checks.Next()
    return found


def distance(shape, point):
    """From a point to a shape, millimetres."""
    vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*map(float, point))).Vertex()
    return BRepExtrema_DistShapeShape(vertex, shape).Value()


def plane_of(points):
    """The plane through points that are in one, or nothing where they are in line."""
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle)
    if spread[1] < 1e-6 * spread[0]:
        return None
    return gp_Pln(gp_Pnt(*map(float, middle)), gp_Dir(*map(float, axes[2])))


def section(shape, points):
    """The cut of a shape by the plane through points."""
    plane = plane_of(points)
    if plane is None:
        return None
    cut = BRepAlgoAPI_Section(shape, plane, False)
    cut.ComputePCurveOn1(False)
    cut.Approximation(True)
    cut.Build()
    return cut.Shape()


def judge_shape(tally, shape, wanted):
    """What was read is sound, and as much as is wanted."""
    tally.ok(BRepCheck_Analyzer(shape).IsValid(), 'BRepCheck finds no fault')
    if wanted.sets is not None:
        found = len(curve_sets(shape))
        tally.ok(found == wanted.sets, f'sets of curves: {found}')
    for name, kind in KINDS.items():
        count = getattr(wanted, name)
        if count is not None:
            found = len(parts(shape, kind))
            tally.ok(found == count, f'{name}: {found}')
    if wanted.curves is not None:
        found = len(parts(shape, TopAbs_EDGE)) - sum(
            len(parts(face, TopAbs_EDGE)) for face in parts(shape, TopAbs_FACE))
        tally.ok(found == wanted.curves, f'curves: {found}')
    if wanted.free is not None:
        found = sum(len(free_edges(shell)) for shell in parts(shape, TopAbs_SHELL))
        tally.ok(found == wanted.free, f'free edges: {found}')
    for solid in parts(shape, TopAbs_SOLID):
        tally.ok(volume([solid]) > 0, 'a solid is not inside out')
    if wanted.gap is not None:
        found = ShapeAnalysis_ShapeTolerance().Tolerance(shape, 1) / wanted.unit
        tally.ok(found <= wanted.gap, f'edges are on their faces within {found:.1e}')


def close(tally, found, wanted, relative, name):
    """Counts a check of a measure."""
    off = abs(found - wanted) / abs(wanted)
    tally.ok(off <= relative, f'{name} {found:.10g}, {off:.1e} off')


def judge_measures(tally, shape, wanted):
    """Areas and volume."""
    faces = parts(shape, TopAbs_FACE)
    if wanted.area is not None:
        close(tally, area(faces) / wanted.unit**2, wanted.area, wanted.relative, 'area')
    if wanted.skin is not None:
        close(tally, area([face for face in faces if not is_flat(face)]) / wanted.unit**2,
              wanted.skin, wanted.relative, 'area without flat faces')
    if wanted.volume is not None:
        close(tally, volume(parts(shape, TopAbs_SOLID)) / wanted.unit**3, wanted.volume,
              wanted.relative, 'volume')


def judge_cuts(tally, shape, cuts, wanted):
    """Points of a cut are on its own set of curves: the first sets of the file, in order."""
    for (name, rows), curves in zip(cuts.items(), curve_sets(shape)):
        worst = max(distance(curves, point) for point in rows[:, :3] * wanted.unit)
        tally.ok(worst <= wanted.within * wanted.unit,
                 f'cut {name}: {len(rows)} points are on its curves within '
                 f'{worst / wanted.unit:.1e}')


def judge_points(tally, skin, cuts, wanted):
    """Points of the exact surface are on the skin, on both sides."""
    points = np.concatenate(list(cuts.values()))[:, :3]
    if wanted.sample and wanted.sample < len(points):
        points = np.random.default_rng(4).permutation(points)[:wanted.sample]
    for side, name in ((1, 'starboard'), (-1, 'port')):
        worst = max(distance(skin, point) for point in points * wanted.unit * [1, side, 1])
        tally.ok(worst <= wanted.within * wanted.unit,
                 f'{len(points)} points are on the skin within {worst / wanted.unit:.1e}, {name}')


def judge_sections(tally, skin, cuts, wanted):
    """The kernel's own cuts go through the points of ours.

    Where a plane meets the skin at a slant, which the bevel tells, its cut is moved by more than
    the skin is.
    """
    for name, rows in cuts.items():
        points = rows[:, :3] * wanted.unit
        cut = section(skin, points)
        if cut is None:
            continue
        slant = np.cos(np.radians(rows[:, 3]))
        worst = max(distance(cut, point) * part for point, part in zip(points, slant))
        tally.ok(worst <= wanted.within * wanted.unit,
                 f'cut {name}: {len(points)} points are on the section of the skin within '
                 f'{worst / wanted.unit:.1e}')


def arguments():
    """The command line."""
    parser = argparse.ArgumentParser(description='Judges a STEP file by OpenCASCADE.')
    parser.add_argument('file')
    parser.add_argument('--unit', type=float, default=1.0, help='millimetres of the unit')
    for name in (*KINDS, 'sets', 'curves', 'free'):
        parser.add_argument('--' + name, type=int, help='how many')
    for name in ('area', 'skin', 'volume', 'gap'):
        parser.add_argument('--' + name, type=float)
    parser.add_argument('--relative', type=float, default=1e-6, help='of areas and volume')
    parser.add_argument('--points', help='CSV of points on the skin')
    parser.add_argument('--sample', type=int, help='of so many points')
    parser.add_argument('--cuts', help='CSV of the cuts that are in the file')
    parser.add_argument('--sections', help='CSV of plane cuts')
    parser.add_argument('--within', type=float, help='distance allowed of points')
    return parser.parse_args()


def main():
    """Reads and judges."""
    wanted, tally = arguments(), Tally()
    reader = STEPControl_Reader()
    tally.ok(reader.ReadFile(wanted.file) == IFSelect_RetDone, f'{wanted.file} can be read')
    roots = reader.NbRootsForTransfer()
    tally.ok(roots == 1 and reader.TransferRoots() == roots, 'it has one product')
    found = complaints(reader)
    tally.ok(not found, f'without complaint {found[:3]}')
    shape = reader.OneShape()
    judge_shape(tally, shape, wanted)
    judge_measures(tally, shape, wanted)
    skin = compound(parts(shape, TopAbs_SHELL))
    if wanted.points:
        judge_points(tally, skin, read_csv(wanted.points), wanted)
    if wanted.cuts:
        judge_cuts(tally, shape, read_csv(wanted.cuts), wanted)
    if wanted.sections:
        judge_sections(tally, skin, read_csv(wanted.sections), wanted)
    tally.finish()


if __name__ == '__main__':
    main()
