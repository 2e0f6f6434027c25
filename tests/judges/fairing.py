"""Judges faired curves with numpy and scipy and prints TAP.

    fairing.py DECK LISTING

The FAIRED outlines and FAIR lines of a deck by columns are solved again: matrices by Gauss
quadrature of scipy's B-splines, dense systems of real numbers, ends held by bordering, the area by bisection.
The listing must give the same figures.
"""
import re
import sys

import numpy
from scipy.interpolate import BSpline
from scipy.optimize import brentq

from outlines import Tally


def basis():
    """Values of the four B-splines of a segment and of their derivatives, by Gauss points."""
    nodes, weights = numpy.polynomial.legendre.leggauss(6)
    u = 0.5*(nodes + 1)
    knots = numpy.arange(-3.0, 5.0)
    splines = [BSpline(knots, numpy.eye(4)[k], 3) for k in range(4)]
    return 0.5*weights, [numpy.array([s(u, order) for s in splines]) for order in range(4)]


def forms(count, is_closed):
    """Matrices of E2, E3 and S of so many vertices."""
    weights, jets = basis()
    local = [(jets[2]*weights) @ jets[2].T, (jets[3]*weights) @ jets[3].T,
             (jets[0]*weights) @ jets[1].T]
    local[2] = 0.5*(local[2] - local[2].T)
    whole = [numpy.zeros((count, count)) for _ in local]
    for first in range(count if is_closed else count - 3):
        at = [(first + k) % count for k in range(4)]
        for matrix, part in zip(whole, local):
            matrix[numpy.ix_(at, at)] += part
    return whole


def places(points, count):
    """The matrix that takes vertices to the points of the curve."""
    matrix = numpy.zeros((points, count))
    for i in range(points):
        for k, share in enumerate((1/6, 4/6, 1/6)):
            matrix[i, (i + k) % count] += share
    return matrix


class Faired:
    """A faired curve."""

    def __init__(self, points, weights, beta, is_closed):
        self.q = numpy.array(points)
        self.weights = numpy.array(weights)
        self.beta = beta
        self.is_closed = is_closed
        n = len(points) if is_closed else len(points) + 2
        self.e2, self.e3, self.turn = forms(n, is_closed)
        self.take = places(len(points), n)

    def solve(self, multiplier):
        """The vertices at a multiplier; an open curve is held at its ends."""
        n = len(self.e2)
        pull = self.take.T*self.weights
        stiff = 2*(self.beta*self.e2 + (1 - self.beta)*self.e3 + pull @ self.take)
        whole = numpy.block([[stiff, multiplier*self.turn], [multiplier*self.turn.T, stiff]])
        right = numpy.concatenate(2*(pull @ self.q).T)
        if not self.is_closed:
            ends = numpy.kron(numpy.eye(2), self.take[[0, -1]])
            whole = numpy.block([[whole, ends.T], [ends, numpy.zeros((4, 4))]])
            right = numpy.concatenate([right, self.q[[0, -1], 0], self.q[[0, -1], 1]])
        return numpy.linalg.solve(whole, right)[:2*n].reshape(2, n).T

    def area(self, vertices):
        """The area within."""
        return vertices[:, 0] @ self.turn @ vertices[:, 1]

    def ordinate(self, vertices, station):
        """Y of an open curve at an X."""
        curve = BSpline(numpy.arange(-3.0, len(vertices) + 1), vertices, 3)
        last = len(vertices) - 3.0
        u = brentq(lambda t: curve(t)[0] - station, 0, last, xtol=1e-14)
        return curve(u)[1]


def fields(line):
    """The fields of a card by columns."""
    return [line[i:i + 8].strip() for i in range(0, 80, 8)]


def number(text, usual):
    """A field as a number."""
    return float(text) if text else usual


def read(deck):
    """The faired cards of a deck: fields of the card, points with their own weights."""
    found = []
    for line in open(deck, encoding='utf-8'):
        if line.startswith('*') or not line.strip():
            continue
        word = fields(line.upper())
        if re.match('[A-Z]', word[0]):
            found.append((word, []))
        else:
            found[-1][1].append([number(f, None) for f in word[:3]])
    return [(w, p) for w, p in found
            if w[0] == 'FAIRED' or w[0] == 'LINE' and w[3] == 'FAIR']


def weights_of(points, usual):
    """The weights of points."""
    return [usual if p[2] is None else p[2] for p in points]


def figures_of(listing, name):
    """What the listing says of an outline, by its words, and its table of points."""
    part = listing[listing.index(f'   {name}   FAIRED OUTLINE'):].split('\nCUT ')[0]
    said = {m[1].strip(): float(m[2]) for m in
            re.finditer(r'^  ([A-Z ]+?) +(-?\d\.\d+E[+-]\d+)', part, re.M)}
    rows = re.findall(r'^ +\d+' + r' +(-?\d+\.\d+)'*5 + '$', part, re.M)
    return said, numpy.array(rows, float)


def judge_outline(tally, listing, word, points):
    """An outline, with its area where one was asked."""
    curve = Faired([p[:2] for p in points], weights_of(points, number(word[3], 10.0)),
                   number(word[4], 0.5), True)
    multiplier = 0.0
    if word[5]:
        multiplier = brentq(lambda m: curve.area(curve.solve(m)) - float(word[5]), -100, 100,
                            xtol=1e-13)
    v = curve.solve(multiplier)
    e2, e3 = (sum(v[:, k] @ e @ v[:, k] for k in (0, 1)) for e in (curve.e2, curve.e3))
    near = curve.take @ v
    said, rows = figures_of(listing, word[1])
    wanted = {'ENERGY OF SECOND DERIVATIVE': e2, 'ENERGY OF THIRD DERIVATIVE': e3,
              'ENERGY': curve.beta*e2 + (1 - curve.beta)*e3, 'AREA': curve.area(v),
              'LARGEST MISFIT': numpy.linalg.norm(near - curve.q, axis=1).max(),
              'MULTIPLIER OF THE AREA': multiplier}
    for name, value in wanted.items():
        tally.ok(abs(said[name] - value) <= 2e-8*abs(value), f'{word[1]}: {name.lower()}',
                 f'{said[name]} and {value}')
    tally.ok(numpy.abs(rows[:len(points), 2:4] - near).max() <= 0.6e-6, f'{word[1]}: its points')


def judge_line(tally, listing, word, points):
    """A faired line: its table."""
    curve = Faired([p[:2] for p in points], weights_of(points, number(word[4], 10.0)), 0.5, False)
    vertices = curve.solve(0.0)
    rows = re.findall(f'^{word[1]} +{word[2]} +[A-Z0-9.]+' + r' +(-?\d+\.\d+)'*4 + '$', listing,
                      re.M)
    rows = numpy.array(rows, float)
    tally.ok(len(rows) == len(points), f'{word[1]} {word[2]}: a row for each point')
    worst = max(abs(row[2] - curve.ordinate(vertices, row[0])) for row in rows[1:-1])
    tally.ok(worst <= 0.51e-3, f'{word[1]} {word[2]}: the faired ordinates', f'{worst}')


def main():
    """Judges a deck."""
    tally = Tally()
    listing = open(sys.argv[2], encoding='utf-8').read()
    for word, points in read(sys.argv[1]):
        if word[0] == 'FAIRED':
            judge_outline(tally, listing, word, points)
        else:
            judge_line(tally, listing, word, points)
    tally.finish()


if __name__ == '__main__':
    main()
