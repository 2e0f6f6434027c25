"""Cut points of a body deck: on their plane, and on their section, whose conic is worked anew.

Judged are bodies of one SYMMETRY, without NOSE, whose lines are plain conics, straight lines and
constants; of others only the planes of station, buttock and waterline cuts.
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

    def __init__(self, fields):
        self.conic = conic_of(fields[:8])
        values = [real(field) for field in fields[:8]]
        self.ends, self.p2 = (values[0], values[5]), (values[3], values[4])
        self.size = self.conic.size

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


class Body:
    """The lines and sections of a deck, where they are plain."""

    def __init__(self, deck):
        self.lines, self.sections, self.planes = {}, {}, {}
        chain = []
        for line in deck.split(b'\n'):
            if not line.strip() or line.startswith(b'*'):
                continue
            f = fields_of(line)
            if f[0] in (b'BODY', b'NOSE', b'SYMMETRY', b'PATCH', b'FAIRED', b'+'):
                raise ValueError(f[0])
            if f[0] == b'END':
                break
            if f[0] == b'LINE':
                chain = []
                if (f[1], f[2]) in self.lines:
                    raise ValueError('a line twice')
                self.lines[f[1], f[2]] = chain
                if f[3]:
                    chain.append(self.constant(f))
            elif f[0] == b'SECTION':
                if f[1] in self.sections:
                    raise ValueError('a section twice')
                self.sections[f[1]] = f
            elif f[0] in (b'STATION', b'BUTTOCK', b'WATERLN'):
                self.planes.setdefault(f[0].lower().replace(b'waterln', b'waterline'), []).append(f)
            else:
                chain.append(self.piece(f))

    @staticmethod
    def constant(f):
        """An ordinate that is the same everywhere."""
        try:
            return real(f[3])
        except ValueError:
            return None

    @staticmethod
    def piece(f):
        """A data card; nothing where it is not plain."""
        try:
            if f[0] == b'STRAIGHT':
                return Straight(*(real(v) for v in f[1:5]))
            return Curve(f) if not any(f[8:]) else None
        except (ValueError, ZeroDivisionError):
            return None

    def ordinate(self, name, view, x):
        """Of a line at a station; ValueError where it is not judged."""
        for piece in self.lines.get((name, view), []):
            if piece is None:
                break
            if isinstance(piece, Fraction):
                return piece
            if min(piece.ends) < x < max(piece.ends):
                return piece.at(x)
        raise ValueError('no ordinate')

    def section(self, name, x):
        """The conic of a section at a station."""
        f = self.sections[name]
        points = [(self.ordinate(n, b'PLAN', x), self.ordinate(n, b'SIDE', x)) for n in f[2:5]]
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
    try:
        body = Body(deck)
    except ValueError:
        return wrong[:3], judged
    for row in rows[::max(1, len(rows)//most)]:
        try:
            sta, bl, wl = (Fraction(float(v)) for v in row[3:6])
            conic = body.section(row[2], sta)
        except (ValueError, KeyError, ZeroDivisionError):
            continue
        judged += 1
        size = max(conic.size, abs(bl), abs(wl), abs(sta))
        if conic.distance((bl, wl)) > NEAR*size:
            wrong.append(f'{b",".join(row).decode()}: {float(conic.distance((bl, wl))):.3g} '
                         'off its section')
    return wrong[:3], judged
