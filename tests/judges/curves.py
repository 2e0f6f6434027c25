"""Judges curves of LOFT against SciPy and NumPy: splines, Bezier and C-Bezier curves, spirals,
degree reduction.

    curves.py batten|c-bezier|blend DECK --csv CUTS.csv
    curves.py lowering DECK --dxf FILE.dxf --within D

The points of each line are read from its deck, the curve is worked out anew with libraries and
formulas that are not LOFT's. Prints the Test Anything Protocol; ends with status 1 where a check
fails.
"""
import argparse
import csv
import math

import numpy as np
from scipy.interpolate import BPoly, BSpline, CubicSpline
from scipy.optimize import brentq

from outlines import Tally


def read_lines(name):
    """Lines of a deck: (name, view) -> list of (word, numbers) of its data cards."""
    lines, cards = {}, None
    for text in open(name):
        if text.startswith('*'):
            continue
        if ',' in text:
            words = [w.strip() for w in text.split(',')]
        else:
            words = [text[i:i + 8].strip() for i in range(0, len(text), 8)]
        if words[0] == 'LINE':
            cards = lines.setdefault((words[1], words[2]), [])
        elif words[0] in ('SECTION', 'STATION', 'WATERLN', 'BUTTOCK', 'END'):
            cards = None
        elif cards is not None:
            is_point = words[0][:1] in '0123456789+-.'
            cards.append((' '.join(w for w in words if w.isalpha()) if is_point else words[0],
                          [float(w) for w in words if w[:1] in tuple('0123456789+-.')]))
    return lines


def read_rows(name):
    """Rows of a CSV file of cuts."""
    with open(name, newline='') as file:
        return [{k: v if k in ('kind', 'section') else float(v) for k, v in row.items()}
                for row in csv.DictReader(file)]


def bezier(points):
    """A Bezier curve by SciPy: parameter -> point."""
    return BPoly(np.array(points)[:, None, :], [0, 1])


def spline(points, is_parabola):
    """The spline of least bending by chords, free, or a parabola at its end: SciPy."""
    points = np.array(points)
    u = np.append(0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    zero = np.zeros(2)
    if not is_parabola:
        return CubicSpline(u, points, bc_type='natural'), u[-1]
    # The cubic term of the last segment is affine in the second derivative at the end.
    ends = [CubicSpline(u, points, bc_type=((2, zero), (2, zero + m))).c[0, -1] for m in (0, 1)]
    bend = ends[0] / (ends[0] - ends[1])
    return CubicSpline(u, points, bc_type=((2, zero), (2, bend))), u[-1]


def cyclic(pole, alpha):
    """A C-Bezier cubic by its printed formulas: t from 0 to alpha -> point."""
    s, c = math.sin(alpha), math.cos(alpha)
    k = (alpha - s) / (1 - c)
    m = 1 if alpha == math.pi else s / (alpha - 2 * k)
    pole = np.array(pole).reshape(4, 2)

    def at(t):
        z0 = ((alpha - t) - math.sin(alpha - t)) / (alpha - s)
        z3 = (t - math.sin(t)) / (alpha - s)
        z1 = m * ((1 - math.cos(alpha - t)) / (1 - c) - z0)
        z2 = m * ((1 - math.cos(t)) / (1 - c) - z3)
        return np.array([z0, z1, z2, z3]) @ pole
    return at


def ordinate(curve, last, station):
    """Y of a curve at an X."""
    t = brentq(lambda u: curve(u)[0] - station, 0, last, xtol=1e-15, rtol=9e-16)
    return curve(t)[1]


def compare_rows(tally, rows, lines, name):
    """Compares rows in a plane of symmetry or at the ends of stations with lines."""
    worst, count = 0, 0
    for row in rows:
        for column, other, curves in lines:
            if abs(row[other]) > 1e-12:
                continue
            for from_, to, curve, last in curves:
                if from_ <= row['sta'] <= to:
                    worst = max(worst, abs(ordinate(curve, last, row['sta']) - row[column]))
                    count += 1
    tally.ok(count >= 5, f'{name}: {count} points of lines')
    tally.ok(worst < 1e-11, f'{name}: they are those of SciPy or NumPy ({worst:.1e})')


def judge_batten(tally, lines, rows):
    """Splines and a Bezier curve: ends of the frames."""
    worst = 0
    shr = {}
    for view in ('SIDE', 'PLAN'):
        cards = lines['SHR', view]
        shr[view] = spline([n[:2] for _, n in cards], 'PARABOLA' in cards[-1][0])
    keel = bezier([n for _, n in lines['KEL', 'SIDE']])
    frames = {row['cut'] for row in rows if row['kind'] == 'station'}
    for cut in sorted(frames):
        frame = [row for row in rows if row['cut'] == cut]
        station = frame[0]['sta']
        low, high = sorted((frame[0], frame[-1]), key=lambda row: row['wl'])
        worst = max(worst, abs(low['wl'] - ordinate(keel, 1, station)),
                    abs(high['wl'] - ordinate(*shr['SIDE'], station)),
                    abs(high['bl'] - ordinate(*shr['PLAN'], station)))
    tally.ok(len(frames) > 2, f'{len(frames)} frames')
    tally.ok(worst < 1e-12, f'sheer and keel are those of SciPy ({worst:.1e})')


def judge_c_bezier(tally, lines, rows):
    """C-Bezier curves: crown and half-breadth."""
    found = {}
    for key in (('UCL', 'SIDE'), ('MHB', 'PLAN')):
        found[key] = [(n[0], n[6], cyclic(n[:8], math.radians(n[8])), math.radians(n[8]))
                      for _, n in lines[key] if len(n) == 9]
    compare_rows(tally, [r for r in rows if r['kind'] == 'station'],
                 [('wl', 'bl', found['UCL', 'SIDE']), ('bl', 'wl', found['MHB', 'PLAN'])],
                 'C-Bezier lines')


def from_line(line, circle, alpha):
    """A spiral from a straight card to a RADIUS card that turns right; theta by root finding."""
    start, way = np.array(line[:2]), np.subtract(line[2:], line[:2])
    along = way / np.linalg.norm(way)
    centre, radius = centre_of(circle)
    off = centre - start
    apart = abs(along[0] * off[1] - along[1] * off[0])
    s, c = math.sin(alpha), math.cos(alpha)
    k = (alpha - s) / (1 - c)
    m = s / (alpha - 2 * k)

    def sides(theta):
        q = (3 * m * m * k * k * math.cos(theta)
             / ((1 - c) * (2 - m + 3 * m * k * s / (1 - c))))
        h = radius * k * k * m / (1 - c) * math.sin(theta) / q**2
        return h, q * h

    theta = brentq(lambda x: sides(x)[1] * math.sin(x) + radius * math.cos(x) - apart, 1e-6, 1.57,
                   xtol=1e-16, rtol=9e-16)
    h, last = sides(theta)
    right = np.array([along[1], -along[0]])
    begin = off @ along + radius * math.sin(theta) - last * math.cos(theta) - 2 * h
    pole = [start + along * (begin + i * h) for i in range(3)]
    pole.append(pole[2] + last * (math.cos(theta) * along + math.sin(theta) * right))
    return np.array(pole)


def centre_of(card):
    """Centre and radius of a RADIUS card X1 Y1 X3 Y3 R."""
    p, q, radius = np.array(card[:2]), np.array(card[2:4]), card[4]
    half = (q - p) / 2
    rise = math.sqrt(radius**2 - half @ half) / np.linalg.norm(half)
    return p + half + math.copysign(rise, radius) * np.array([-half[1], half[0]]), abs(radius)


def judge_blend(tally, lines, rows):
    """Spirals: the one from a line point by point, the others by curvature and by their circles."""
    cards = [n for _, n in lines['UCL', 'SIDE']]
    alpha = math.radians(60)
    pole = from_line(cards[0], cards[2], alpha)
    crown = [(pole[0, 0], pole[3, 0], cyclic(pole, alpha), alpha)]
    keel = [r for r in rows if r['kind'] == 'buttock']
    compare_rows(tally, keel, [('wl', 'bl', crown)], 'a spiral from a line')
    bends = np.array([r['curvature'] for r in keel])
    tally.ok((np.diff(bends[:8]) <= 1e-12).all() and (np.diff(bends[8:]) >= -1e-12).all(),
             'curvature falls to the first circle and rises to the second')
    for card, column in ((cards[2], 'wl'), (cards[4], 'wl')):
        centre, radius = centre_of(card)
        off = [abs(math.hypot(r['sta'] - centre[0], r[column] - centre[1]) - radius)
               for r in keel if abs(abs(r['curvature']) - 1 / radius) < 1e-12]
        tally.ok(len(off) > 0 and max(off) < 1e-12, f'points are on the circle of {radius:g}')
    plan = [r for r in rows if r['kind'] == 'waterline']
    bends = np.array([r['curvature'] for r in plan])
    tally.ok(bends[0] < -0.09 and (np.diff(bends[:8]) >= -1e-12).all(),
             'curvature rises from the small circle to the large')


def nearest_lower(pole, degree):
    """The nearest curve of a degree that keeps ends and tangents: least squares at Gauss points."""
    n = len(pole) - 1
    t, w = np.polynomial.legendre.leggauss(40)
    t, root = (t + 1) / 2, np.sqrt(w / 2)
    basis = np.array([math.comb(degree, i) * t**i * (1 - t)**(degree - i)
                      for i in range(degree + 1)]).T
    lower = np.zeros((degree + 1, pole.shape[1]))
    lower[0], lower[-1] = pole[0], pole[-1]
    lower[1] = pole[0] + n / degree * (pole[1] - pole[0])
    lower[-2] = pole[-1] - n / degree * (pole[-1] - pole[-2])
    rest = bezier(pole)(t) - basis @ lower
    lower[2:-2] = np.linalg.lstsq(root[:, None] * basis[:, 2:-2], root[:, None] * rest,
                                  rcond=None)[0]
    return lower


def judge_lowering(tally, lines, options):
    """A BEZIER line in a DXF file: near the curve, and piece by piece the nearest one."""
    import ezdxf
    pole = np.array([n for _, n in lines['UCL', 'SIDE']])
    drawing = ezdxf.readfile(options.dxf)
    entity = [e for e in drawing.modelspace() if e.dxf.layer == 'UCL'][0]
    drawn = BSpline(np.array(entity.knots), np.array(entity.control_points), entity.dxf.degree)
    t = np.linspace(0, 1, 5001)
    u = entity.knots[0] + t * (entity.knots[-1] - entity.knots[0])
    points = np.array(drawn(u))[:, [0, 2]]
    off = np.linalg.norm(points - bezier(pole)(t), axis=1).max()
    tally.ok(entity.dxf.degree == 5, 'it is of degree 5')
    tally.ok(off <= options.within, f'it is near the curve ({off:.1e})')
    pieces = len(set(entity.knots)) - 1
    worst = 0
    for i in range(pieces):
        a, b = i / pieces, (i + 1) / pieces
        part = np.linalg.solve(
            np.array([[math.comb(len(pole) - 1, j) * s**j * (1 - s)**(len(pole) - 1 - j)
                       for j in range(len(pole))] for s in np.linspace(0, 1, len(pole))]),
            bezier(pole)(a + (b - a) * np.linspace(0, 1, len(pole))))
        wanted = bezier(nearest_lower(part, 5))(np.linspace(0, 1, 50))
        have = bezier_points(drawn, entity.knots, a, b)
        worst = max(worst, np.abs(wanted - have).max())
    tally.ok(worst < 1e-7, f'its {pieces} pieces are the nearest of their degree ({worst:.1e})')


def bezier_points(drawn, knots, a, b):
    """Points of a part of a spline, STA and WL."""
    t = a + (b - a) * np.linspace(0, 1, 50)
    return np.array(drawn(knots[0] + t * (knots[-1] - knots[0])))[:, [0, 2]]


def main():
    """Judges one deck."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('what', choices=['batten', 'c-bezier', 'blend', 'lowering'])
    parser.add_argument('deck')
    parser.add_argument('--csv')
    parser.add_argument('--dxf')
    parser.add_argument('--within', type=float)
    options = parser.parse_args()
    tally = Tally()
    lines = read_lines(options.deck)
    if options.what == 'lowering':
        judge_lowering(tally, lines, options)
    else:
        judge = {'batten': judge_batten, 'c-bezier': judge_c_bezier, 'blend': judge_blend}
        judge[options.what](tally, lines, read_rows(options.csv))
    tally.finish()


if __name__ == '__main__':
    main()
