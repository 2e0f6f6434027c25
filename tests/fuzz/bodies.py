"""Cut points of a body deck: on their plane, and on their section: the conic through its control
lines, worked anew.

Judged are sections of bodies without NOSE, as far as their lines are conics (by shoulder point, rho
or tangents), circles through points, straight lines, constants and copies; of others only the planes
of station, buttock and waterline cuts.
"""
from fractions import Fraction

from oracle import Conic, conic_of, direction, real, root

HEADER = b'cut,kind,section,sta,bl,wl,slope,curvature,bevel'
NEAR = Fraction(1, 10**9)


def fields_of(line):
    """The fields of a card of a body deck, capitals, ten at least."""
    line = line.rstrip(b'\r').upper()
    if b',' in line:
        fields = [field.strip() for field in line.split(b',')]
    else:
        fields = [line[i:i + 8].strip() for i in range(0, 80, 8)]
    return fields + [b'']*(12 - len(fields))


class Straight:
    """A straight line of a chain."""

    def __init__(self, x1, y1, x3, y3):
        self.ends, self.size = (x1, x3), max(map(abs, (x1, y1, x3, y3)))
        self.p, self.s = (x1, y1), (y3 - y1)/(x3 - x1)

    def at(self, x):
        """Its ordinate."""
        return self.p[1] + self.s*(x - self.p[0])


class Curve:
    """A conic of a chain."""

    def __init__(self, conic, p1, p2, p3):
        self.conic, self.p2, self.ends = conic, p2, (p1[0], p3[0])
        self.size = conic.size

    def at(self, x):
        """Its ordinate, between the tangents and the chord; ValueError where that is not one."""
        (a, b), c, k = self.conic.tangents, self.conic.chord, self.conic.k
        u, v, w = (line[0]*x + line[2] for line in (a, b, c))
        two, one, nil = a[1]*b[1] - k*c[1]**2, a[1]*v + b[1]*u - 2*k*c[1]*w, u*v - k*w**2
        if two == 0:
            found = [-nil/one] if one else []
        else:
            square = one**2 - 4*two*nil
            if square < 0:
                raise ValueError('no ordinate')
            found = [(-one + sign*root(square))/(2*two) for sign in (1, -1)]
        inside = [y for y in found if self.holds((x, y))]
        if len(inside) != 1:
            raise ValueError('not one ordinate')
        return inside[0]

    def holds(self, point):
        """True between the tangents and the chord."""
        return all(Conic.at(l, point)*Conic.at(l, self.p2) > 0
                   for l in (*self.conic.tangents, self.conic.chord))


def rho_conic(p1, s1, p3, s3, rho):
    """The conic of end points, end directions and rho; the shoulder point is opposite to the chord."""
    (x1, y1), (x3, y3) = p1, p3
    across = s1[0]*s3[1] - s1[1]*s3[0]
    along = ((x3 - x1)*s3[1] - (y3 - y1)*s3[0])/across
    tip = (x1 + along*s1[0], y1 + along*s1[1])
    p2 = tuple((1 - rho)*(a + b)/2 + rho*t for a, b, t in zip(p1, p3, tip))
    return Curve(Conic(p1, s1, p2, p3, s3), p1, p2, p3)


def tangent_conic(p1, tip, p2, p3):
    """The conic of end points, the point where their tangents meet, and the shoulder point."""
    s1, s3 = ((tip[0] - p1[0], tip[1] - p1[1]), (p3[0] - tip[0], p3[1] - tip[1]))
    return Curve(Conic(p1, s1, p2, p3, s3), p1, p2, p3)


def circle(p1, p2, p3):
    """The circle through three points, as a conic by its tangents."""
    (ax, ay), (bx, by) = ((p[0] - p1[0], p[1] - p1[1]) for p in (p2, p3))
    area = 2*(ax*by - ay*bx)
    a, b = ax**2 + ay**2, bx**2 + by**2
    centre = (p1[0] + (by*a - ay*b)/area, p1[1] + (ax*b - bx*a)/area)
    s1, s3 = ((centre[1] - p[1], p[0] - centre[0]) for p in (p1, p3))
    return Curve(Conic(p1, s1, p2, p3, s3), p1, p2, p3)


def pairs(values):
    """Numbers as points."""
    return list(zip(values[::2], values[1::2]))


def piece_of(f):
    """A data card; nothing where it is not plain."""
    word, last = f[0], {b'STRAIGHT': 5, b'CIRCLE': 7, b'RHO': 8, b'TANRHO': 8, b'TANGENT': 9}
    count = last.get(word, 8)
    if any(f[count:]) and [g for g in f[count:] if g] != [b'KNUCKLE']:
        return None
    try:
        if word not in last:
            v = [real(g) for g in f[:8]]
            return Curve(conic_of(f[:8]), (v[0], v[1]), (v[3], v[4]), (v[5], v[6]))
        v = [real(g) for g in f[1:count]]
        if word == b'STRAIGHT':
            return Straight(*v)
        if word == b'CIRCLE':
            return circle(*pairs(v))
        if word == b'RHO':
            return rho_conic((v[0], v[1]), direction(v[2]), (v[3], v[4]), direction(v[5]), v[6])
        points = pairs(v[:6])
        if word == b'TANRHO':
            (x1, y1), (xt, yt), (x3, y3) = points
            return rho_conic((x1, y1), (xt - x1, yt - y1), (x3, y3), (x3 - xt, y3 - yt), v[6])
        return tangent_conic(*pairs(v))
    except (ValueError, ZeroDivisionError):
        return None


class Body:
    """The lines and sections of a deck, where they are plain."""

    SETTINGS = (b'VARY', b'TITLE', b'UNITS', b'*')
    DATA = (b'RHO', b'TANGENT', b'TANRHO', b'FOURPT', b'FIVEPT', b'STRAIGHT', b'CIRCLE', b'RADIUS',
            b'CBEZIER', b'BLEND')

    def __init__(self, deck):
        self.sections = {}
        self.lines, self.chain, self.own = {}, [], []
        for line in deck.split(b'\n'):
            if not line.strip() or line.startswith(b'*'):
                continue
            f = fields_of(line)
            if f[0] == b'END':
                break
            self.take(f)
        self.forget_rounded()

    def take(self, f):
        """A card of the deck."""
        word = f[0]
        if word == b'LINE':
            self.chain = self.chain_of(f)
            self.lines[f[1], f[2]] = None if (f[1], f[2]) in self.lines else self.chain
        elif word == b'SECTION':
            self.chain = []
            self.own.append(f[1])
            self.sections[f[1]] = None if f[1] in self.sections else (f, self.lines)
        elif word == b'BODY':
            self.forget_rounded()
            self.lines, self.chain, self.own = {}, [], []
        elif word == b'NOSE':
            self.lines[b'NOSE', b'NOSE'] = []
        elif word == b'+' and self.chain:
            self.chain[-1] = None
        elif word in self.DATA or word[:1].isdigit() or word[:1] in (b'-', b'+', b'.'):
            self.chain.append(piece_of(f))
        elif word[:1].isalpha() and word not in self.SETTINGS:
            self.chain = []

    def chain_of(self, f):
        """The pieces of a line that its first card gives: a constant, or those of another line."""
        if not f[3]:
            return []
        try:
            return [real(f[3])]
        except ValueError:
            return list(self.lines.get((f[3], f[2])) or [None])

    def forget_rounded(self):
        """Sections of a body with a nose are not conics all along."""
        if (b'NOSE', b'NOSE') in self.lines:
            self.sections.update(dict.fromkeys(self.own))

    @staticmethod
    def ordinate(lines, name, view, x):
        """Of a line at a station; ValueError where it is not judged."""
        for piece in lines.get((name, view)) or []:
            if piece is None:
                break
            if isinstance(piece, Fraction):
                return piece
            if min(piece.ends) < x < max(piece.ends):
                return piece.at(x)
        if view == b'PLAN' and (name, view) not in lines and (name, b'SIDE') in lines:
            return Fraction(0)
        raise ValueError('no ordinate')

    def section(self, name, x):
        """The conic of a section at a station."""
        f, lines = self.sections[name] or ([], {})
        if not f:
            raise ValueError('a name twice, or a nose')
        points = [tuple(self.ordinate(lines, n, view, x) for view in (b'PLAN', b'SIDE'))
                  for n in f[2:5]]
        slopes = [direction(real(v)) for v in f[5:7]]
        return Conic(points[0], slopes[0], points[1], points[2], slopes[1])


def cut_points(deck, table, most=200):
    """Complaints about rows of a CSV of cuts, and how many were judged."""
    rows = table.split(b'\n')
    if rows[0] != HEADER:
        return (['no CSV header'] if table else []), 0
    rows, wrong, judged = [row.split(b',') for row in rows[1:-1]], [], 0
    if any(len(row) != 9 for row in rows):
        return ['a row of CSV without nine fields'], 0
    column = {b'station': 3, b'buttock': 4, b'waterline': 5}
    plane = {}
    for row in rows:
        if row[1] in column:
            value = row[column[row[1]]]
            judged += 1
            if plane.setdefault(row[0], value) != value:
                wrong.append(f'{b",".join(row).decode()}: off its plane')
    body = Body(deck)
    for row in rows[::max(1, len(rows)//most)]:
        try:
            sta, bl, wl = (Fraction(float(v)) for v in row[3:6])
            conic = body.section(row[2], sta)
        except (ValueError, KeyError, ZeroDivisionError):
            continue
        judged += 1
        size = max(conic.size, abs(bl), abs(wl), abs(sta))
        off = min(conic.distance((side*bl, wl)) for side in (1, -1))
        if off > NEAR*size:
            wrong.append(f'{b",".join(row).decode()}: {float(off):.3g} off its section')
    return wrong[:3], judged
