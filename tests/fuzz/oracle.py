"""What must hold of a run, whatever the deck: its end, its words, and where its points lie.

The points are judged in exact fractions, by the conics' implicit equations: nothing here is how LOFT
computes. A card that is not plain (five figures between points, no other form) is not judged.
"""
import math
import re
from fractions import Fraction

PLAIN = re.compile(rb' *[-+]?(\d+\.\d*|\.\d+) *$')
ULP = Fraction(1, 2**52)
#: A slope of this size is vertical.
VERTICAL = Fraction(float('999.99'))
REPORTS = re.compile(rb'runtime error|AddressSanitizer|LeakSanitizer|Fortran runtime|Backtrace|'
                     rb'\bSIG(?:SEGV|FPE|ABRT|BUS|ILL)\b|or at fault|core dumped|At line \d+ of file|stack smashing|free\(\)')
BAD = re.compile(rb'(?<![A-Za-z])(nan|-?infinity)(?![A-Za-z])', re.I)


def ending(status, errors):
    """Complaints about how a run ended: its exit status against its words."""
    wrong = []
    place = re.search(rb'at (src/[\w/]*\.f90:\d+)|At line (\d+ of file \S+)', errors)
    place = ' ' + (place[1] or place[2]).decode() if place else ''
    if status < 0:
        wrong.append(f'ended by signal {-status}{place}')
    elif status not in (0, 1, 2):
        wrong.append(f'exit status {status}')
    if REPORTS.search(errors):
        wrong.append('report: ' + REPORTS.search(errors).group().decode() + place)
    has_error = re.search(rb'^[^\n]*?:[\d:\-]* error: ', errors, re.M) is not None
    has_trouble = re.search(rb'^loft: ', errors, re.M) is not None
    if status == 0 and (has_error or has_trouble):
        wrong.append('status 0 with an error')
    if status == 1 and not has_error:
        wrong.append('status 1 without an error')
    if status == 2 and not has_trouble:
        wrong.append('status 2 without a reason')
    return wrong


class Conic:
    """l1*l3 = k*c**2: tangents at the ends, the chord, the shoulder point."""

    def __init__(self, p1, s1, p2, p3, s3):
        self.tangents = [self.line(p1, s1), self.line(p3, s3)]
        (x1, y1), (x3, y3) = p1, p3
        self.chord = (y1 - y3, x3 - x1, x1*y3 - x3*y1)
        c = self.at(self.chord, p2)
        if c == 0:
            raise ValueError('shoulder point on the chord')
        self.k = self.at(self.tangents[0], p2)*self.at(self.tangents[1], p2)/c**2
        if self.k == 0:
            raise ValueError('a straight line')
        self.size = max(abs(v) for p in (p1, p2, p3) for v in p)

    @staticmethod
    def line(point, slope):
        """The line through a point; a slope is (dx, dy)."""
        dx, dy = slope
        return (-dy, dx, dy*point[0] - dx*point[1])

    @staticmethod
    def at(line, point):
        """The left side of a line's equation."""
        return line[0]*point[0] + line[1]*point[1] + line[2]

    def distance(self, point):
        """How far a point is from the curve, by the first two terms of the distance."""
        l1, l3, c = (self.at(l, point) for l in (*self.tangents, self.chord))
        value = l1*l3 - self.k*c**2
        (a, b), d = self.tangents, self.chord
        slope = [a[i]*l3 + b[i]*l1 - 2*self.k*c*d[i] for i in (0, 1)]
        bend = [2*abs(a[i]*b[i] - self.k*d[i]**2) for i in (0, 1)]
        norm = root(slope[0]**2 + slope[1]**2)
        near = abs(value)/norm if norm else None
        if bend[0] + bend[1] > 0:
            flat = root(abs(value)/max(bend))
            near = flat if near is None else min(near, flat)
        return near or Fraction(0)

    def slope(self, point):
        """(dx, dy) of the curve at a point of it."""
        l1, l3, c = (self.at(l, point) for l in (*self.tangents, self.chord))
        (a, b), d = self.tangents, self.chord
        fx, fy = (a[i]*l3 + b[i]*l1 - 2*self.k*c*d[i] for i in (0, 1))
        return (-fy, fx)


def root(value):
    """A square root, good to 15 figures at any size."""
    if value == 0:
        return Fraction(0)
    shift = (value.numerator.bit_length() - value.denominator.bit_length())//2
    scaled = value*Fraction(4)**-shift
    return Fraction(math.sqrt(scaled))*Fraction(2)**shift


def real(field):
    """The double that a field says, as a fraction; ValueError where it is not plain."""
    if not PLAIN.match(field):
        raise ValueError(field)
    value = float(field)
    if not math.isfinite(value):
        raise ValueError(field)
    return Fraction(value)


def direction(slope):
    """A punched slope as (dx, dy)."""
    return (Fraction(0), Fraction(1)) if abs(slope) >= VERTICAL else (Fraction(1), slope)


def cards_1970(deck):
    """The cards of a 1970 deck that count, and of each its conic where it is plain."""
    for line in deck.split(b'\n'):
        line = line.rstrip(b'\r')
        if not line.strip() or line.startswith(b'*'):
            continue
        if line[:8].strip()[:1].isalpha():
            continue
        try:
            x1 = real(line[:8])
        except ValueError:
            return
        if x1 >= Fraction(99999, 100):
            return
        try:
            yield conic_of(line[i:i + 8] for i in range(0, 64, 8))
        except ValueError:
            yield None


def conic_of(fields):
    """The conic of the eight fields of a card; ValueError where it is not judged."""
    x1, y1, s1, x2, y2, x3, y3, s3 = (real(field) for field in fields)
    conic = Conic((x1, y1), direction(s1), (x2, y2), (x3, y3), direction(s3))
    for s in (s1, s3):
        if abs(s) < VERTICAL and abs(y3 - y1 - s*(x3 - x1)) <= abs(x3 - x1)/10**4:
            raise ValueError('a tangent along the chord')
    return conic


def conic_points(deck, table, most=300):
    """Complaints about the rows of a CSV of a 1970 deck that are not on their conic."""
    rows = table.split(b'\n')
    if rows[0] != b'card,axis,x,y,slope,curvature':
        return (['no CSV header'] if table else []), 0
    rows = rows[1:-1]
    cards, wrong, judged = list(cards_1970(deck)), [], 0
    for row in rows[::max(1, len(rows)//most)]:
        fields = row.split(b',')
        if len(fields) != 6:
            return wrong + ['a row of CSV without six fields'], judged
        card = int(fields[0])
        conic = cards[card - 1] if card <= len(cards) else None
        if conic is None:
            continue
        judged += 1
        point = tuple(Fraction(float(f)) for f in fields[2:4])
        size = max(conic.size, *(abs(v) for v in point))
        if conic.distance(point) > 64*ULP*size:
            ulps = float(conic.distance(point)/(ULP*size))
            wrong.append(f'{row.decode()}: {ulps:.3g} ulp off its conic')
    return wrong[:3], judged


def words(table):
    """Numbers that are none."""
    return ['prints ' + BAD.search(table).group().decode()] if BAD.search(table) else []
