"""Judges a DXF file of LOFT by ezdxf: its structure, units, layers, and where its curves are.

    dxf.py FILE --csv CUTS.csv --within D [--back D] [--units N] [--version AC1009] [--space]
           [--arcs] ...

Prints the Test Anything Protocol; ends with status 1 where a check fails.
"""
import argparse
import re

import ezdxf
import ezdxf.path
import numpy as np

from outlines import Tally, add_options, compare, read_cuts

WORDS = {1: 'INCHES', 2: 'FEET', 4: 'MM', 6: 'M'}
OTHERS = {'0', 'REFERENCE', 'TEXT', 'DEFPOINTS'}
ARC_CHORDS = 1e-6


def polygon(entity, fineness):
    """Points along an entity; of a spline so many that their chords are good enough."""
    kind = entity.dxftype()
    if kind in ('POLYLINE', 'LWPOLYLINE') and entity.has_arc:
        points = [p.xyz for p in ezdxf.path.make_path(entity).flattening(ARC_CHORDS)]
    elif kind == 'LWPOLYLINE':
        points = [(x, y, 0) for x, y in entity.get_points('xy')]
        if entity.closed:
            points.append(points[0])
    elif kind == 'POLYLINE':
        points = [v.dxf.location.xyz for v in entity.vertices]
        if entity.is_closed:
            points.append(points[0])
    elif kind == 'LINE':
        points = [entity.dxf.start.xyz, entity.dxf.end.xyz]
    elif kind == 'POINT':
        points = [entity.dxf.location.xyz]
    elif kind == 'SPLINE':
        curve = entity.construction_tool()
        breaks = np.unique(curve.knots())
        t = np.concatenate([np.linspace(a, b, fineness) for a, b in zip(breaks, breaks[1:])])
        points = [p.xyz for p in curve.points(t)]
    else:
        raise ValueError(f'{kind} on a layer of shapes')
    return np.array(points)


def judge_structure(tally, document, options):
    """Version, units, layers, kinds of entities, words."""
    auditor = document.audit()
    for trouble in auditor.errors + auditor.fixes:
        print('#', trouble.code, trouble.message)
    tally.ok(not auditor.errors and not auditor.fixes, 'ezdxf finds nothing to complain of')
    tally.ok(document.dxfversion == options.version, f'the version is {document.dxfversion}')
    tally.ok(document.header['$INSUNITS'] == options.units,
             f'its unit is number {document.header["$INSUNITS"]}')
    names = [layer.dxf.name for layer in document.layers]
    tally.ok(all(re.fullmatch('[A-Z0-9$_-]{1,31}', n) for n in names if n != 'Defpoints'),
             'R12 allows the names of layers')
    words = [e.dxf.text for e in document.modelspace().query('TEXT')]
    tally.ok(f'ALL DIMENSIONS IN {WORDS[options.units]}' in words, 'the unit stands in words')
    limits = np.array([document.header['$EXTMIN'], document.header['$EXTMAX']])
    tally.ok((limits[0] < limits[1]).sum() >= 2, 'it has limits')
    return [n for n in names if n.upper() not in OTHERS]


def bulges_of(entity):
    """The bulges of a polyline, that of the last corner of an open one left out."""
    if entity.dxftype() == 'LWPOLYLINE':
        bulges, closed = [b for _, _, b in entity.get_points('xyb')], entity.closed
    else:
        bulges, closed = [v.dxf.get('bulge', 0) for v in entity.vertices], entity.is_closed
    return bulges if closed else bulges[:-1]


def judge_arcs(tally, entities):
    """There are arcs, and none of more than 180 degrees."""
    bulges = np.concatenate([bulges_of(e) for e in entities
                             if e.dxftype() in ('POLYLINE', 'LWPOLYLINE')])
    tally.ok(np.count_nonzero(bulges) > 0, f'{np.count_nonzero(bulges)} arcs')
    tally.ok(abs(bulges).max() <= 1, 'no arc turns by more than 180 degrees')


def judge_shapes(tally, document, layers, options):
    """Kinds of entities of each layer; the polygons of those of outsides."""
    found = {}
    splines = document.dxfversion != 'AC1009'
    allowed = {'SPLINE', 'LINE', 'POINT'} if splines else {'POLYLINE', 'POINT'}
    if options.arcs and splines:
        allowed |= {'LWPOLYLINE'}
    kinds = {e.dxftype() for e in document.modelspace() if e.dxf.layer in layers}
    tally.ok(kinds <= allowed, f'shapes are {", ".join(sorted(kinds))}')
    if options.arcs:
        judge_arcs(tally, [e for e in document.modelspace() if e.dxf.layer in layers])
    dimensions = 3 if options.space else 2
    for layer in layers:
        entities = document.modelspace().query(f'*[layer=="{layer}"]')
        if not layer.endswith('-IN'):
            found[layer] = [polygon(e, options.fineness)[:, :dimensions] for e in entities]
        if not entities:
            tally.ok(False, f'there is something on layer {layer}')
    return found


def main():
    """Judges the file of the command line."""
    parser = argparse.ArgumentParser()
    add_options(parser)
    parser.add_argument('--version', default='AC1009')
    parser.add_argument('--units', type=int, default=1, help='number of $INSUNITS')
    parser.add_argument('--space', action='store_true', help='the drawing is in space')
    parser.add_argument('--arcs', action='store_true', help='polylines have arcs')
    parser.add_argument('--lines', type=int, default=0, help='control lines there must be')
    parser.add_argument('--fineness', type=int, default=400, help='points of a span of a spline')
    options = parser.parse_args()
    tally = Tally()
    document = ezdxf.readfile(options.file)
    layers = judge_structure(tally, document, options)
    found = judge_shapes(tally, document, layers, options)
    cuts = read_cuts(options.csv, options.factor)
    wanted = options.cuts or len(cuts)
    tally.ok(len(found) == wanted + options.lines,
             f'{wanted} cuts and {options.lines} lines have a layer each')
    compare(tally, cuts, dict(zip(sorted(cuts), found.values())), options)
    tally.finish()


if __name__ == '__main__':
    main()
