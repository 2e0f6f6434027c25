"""Judges a duct with scipy and OpenCASCADE and prints TAP.

    duct.py DECK LISTING POINTS.csv FILE.step

The outlines are faired again as in fairing.py. Through points of them at equal parameters goes a
natural cubic spline of scipy's, at every parameter around; how far apart the outlines are in it is
taken from periodic splines of scipy's through those points. The listing must have the areas,
perimeters, centres and the volume of that surface, the points of all cuts must lie on it, and so
must the faces that OpenCASCADE reads.
"""
import csv
import re
import sys
from math import lcm

import numpy
from OCP.BRep import BRep_Tool
from OCP.BRepAlgoAPI import BRepAlgoAPI_Section
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
from OCP.GProp import GProp_GProps
from scipy.interpolate import BSpline, CubicSpline, make_interp_spline
from scipy.optimize import brentq

from coons import faces_of
from fairing import Faired, fields, number, read, weights_of
from outlines import Tally

NODES, WEIGHTS = numpy.polynomial.legendre.leggauss(10)


def closed_curve(vertices):
    """The curve of a ring of vertices over 0 to 1, begun where LOFT's begins."""
    n = len(vertices)
    around = numpy.vstack([vertices, vertices[:3]])
    spline = BSpline(numpy.arange(-3.0, n + 4), around, 3)
    return lambda s: spline(numpy.mod(s, 1.0)*n)


class Duct:
    """The surface of a DUCT card."""

    def __init__(self, outlines):
        """Outlines: (station, vertices), counter-clockwise or not."""
        self.stations = numpy.array([sta for sta, _ in outlines])
        self.curves = []
        for _, vertices in outlines:
            curve = closed_curve(vertices)
            points = curve(numpy.linspace(0, 1, 400, endpoint=False))
            turn = numpy.sum(points[:, 0]*numpy.roll(points[:, 1], -1)
                             - points[:, 1]*numpy.roll(points[:, 0], -1))
            self.curves.append(curve if turn > 0 else lambda s, c=curve: c(-numpy.asarray(s)))
        self.count = lcm(*[len(v) for _, v in outlines])
        s = numpy.arange(self.count + 1)/self.count
        rings = []
        for curve in self.curves:
            points = curve(s)
            points[-1] = points[0]
            rings.append(make_interp_spline(s, points, 3, bc_type='periodic').c[:self.count])
        steps = [numpy.sqrt(numpy.sum((b - a)**2) + self.count*h**2) for a, b, h in
                 zip(rings, rings[1:], numpy.diff(self.stations))]
        self.t = numpy.concatenate([[0], numpy.cumsum(steps)])
        self.along = CubicSpline(self.t, self.stations, bc_type='natural')

    def spline(self, s):
        """The lines along at some parameters around."""
        return CubicSpline(self.t, numpy.array([c(s) for c in self.curves]), bc_type='natural')

    def at(self, s, t):
        """Points at some parameters around and one along."""
        flat = self.spline(s)(t)
        return numpy.hstack([numpy.full((len(flat), 1), self.along(t)), flat])

    def place(self, station):
        """The parameter of a station."""
        if station <= self.stations[0]:
            return 0.0
        if station >= self.stations[-1]:
            return self.t[-1]
        return brentq(lambda t: self.along(t) - station, 0, self.t[-1], xtol=1e-14)

    def quadrature(self):
        """Places and weights around: Gauss's on each piece."""
        s = (numpy.arange(self.count)[:, None] + 0.5*(NODES + 1)).ravel()/self.count
        return s, numpy.tile(0.5*WEIGHTS/self.count, self.count)

    def jets(self, s, t):
        """Points and tangents around of a section; tangents by small steps, which the cubics of
        one piece allow."""
        h = 1e-3/self.count
        spline = self.spline(numpy.concatenate([s - 2*h, s - h, s, s + h, s + 2*h]))
        p = numpy.split(spline(t), 5)
        return p[2], (p[0] - 8*p[1] + 8*p[3] - p[4])/(12*h)

    def measures(self, station):
        """Area, perimeter and centre of a section."""
        s, w = self.quadrature()
        p, d = self.jets(s, self.place(station))
        cross = w*(p[:, 0]*d[:, 1] - p[:, 1]*d[:, 0])
        area = 0.5*cross.sum()
        return numpy.array([area, w @ numpy.linalg.norm(d, axis=1),
                            *(cross @ p)/(3*area)])

    def volume(self):
        """The integral of the areas, stretch by stretch."""
        total = 0.0
        for a, b in zip(self.t, self.t[1:]):
            for x, w in zip(NODES, WEIGHTS):
                t = 0.5*(a + b) + 0.5*(b - a)*x
                total += 0.5*(b - a)*w*self.along(t, 1)*self.measures(self.along(t))[0]
        return total

    def skin(self):
        """The area of the surface."""
        s, w = self.quadrature()
        total, spline = 0.0, self.spline(s)
        for a, b in zip(self.t, self.t[1:]):
            for x, weight in zip(NODES, WEIGHTS):
                t = 0.5*(a + b) + 0.5*(b - a)*x
                p, d = self.jets(s, t)
                around = numpy.hstack([numpy.zeros((len(d), 1)), d])
                forth = numpy.hstack([numpy.full((len(d), 1), self.along(t, 1)), spline(t, 1)])
                total += 0.5*(b - a)*weight*(w @ numpy.linalg.norm(numpy.cross(around, forth),
                                                                   axis=1))
        return total

    def off(self, point):
        """The distance of a point from the section at its station."""
        t = self.place(point[0])
        s = numpy.linspace(0, 1, 20*self.count, endpoint=False)
        near = s[numpy.argmin(numpy.linalg.norm(self.spline(s)(t) - point[1:], axis=1))]
        step = 1/(20*self.count)

        def way(x):
            p, d = self.jets(numpy.array([x]), t)
            return p[0] - point[1:], d[0]

        foot = brentq(lambda x: numpy.dot(*way(x)), near - step, near + step, xtol=1e-15)
        return numpy.linalg.norm(way(foot)[0])


def ducts_of(deck):
    """The ducts of a deck by name."""
    outlines = {}
    for word, points in read(deck):
        if word[0] != 'FAIRED':
            continue
        curve = Faired([p[:2] for p in points], weights_of(points, number(word[3], 10.0)),
                       number(word[4], 0.5), True)
        sense = numpy.sign(curve.area(curve.q)) or 1.0
        multiplier = 0.0
        if word[5]:
            multiplier = brentq(lambda m: curve.area(curve.solve(m)) - sense*float(word[5]), -100,
                                100, xtol=1e-13)
        outlines[word[1]] = float(word[2]), curve.solve(multiplier)
    cards = [fields(line.upper()) for line in open(deck, encoding='utf-8')]
    return {c[1]: Duct([outlines[name] for name in c[2:] if name]) for c in cards if c[0] == 'DUCT'}


def judge_listing(tally, name, duct, listing):
    """The table of sections and the volume."""
    part = listing[listing.index(f'DUCT {name} THROUGH'):].split('\nCUT ')[0]
    rows = re.findall('^' + r' +(-?\d+\.\d+)'*6 + '(?:  [A-Z]+)?$', part, re.M)
    decimals = len(rows[0][0].split('.')[1])
    worst = 0.0
    for row in numpy.array(rows, float):
        wanted = duct.measures(row[0])
        wanted = [*wanted[:2], 4*wanted[0]/wanted[1], *wanted[2:]]
        worst = max(worst, numpy.abs(row[1:] - wanted).max())
    tally.ok(len(rows) > 3 and worst <= 0.501*10.0**-decimals,
             f'{name}: {len(rows)} areas, perimeters, diameters, centres: {worst:.1e}')
    said = float(re.search(r'VOLUME FROM STA .* (\S+)$', part, re.M)[1])
    tally.ok(abs(said - duct.volume()) <= 1e-9*said, f'{name}: the volume {said}')


def judge_points(tally, name, duct, points):
    """The points of all cuts."""
    with open(points, newline='', encoding='utf-8') as file:
        rows = [[float(row[c]) for c in ('sta', 'bl', 'wl')] for row in csv.DictReader(file)
                if row['section'] == name]
    worst = max(duct.off(numpy.array(row)) for row in rows)
    tally.ok(len(rows) > 100 and worst <= 1e-10, f'{name}: {len(rows)} points of cuts: {worst:.1e}')


def mass(properties, shape, *more):
    """What OpenCASCADE measures of a shape."""
    found = GProp_GProps()
    properties(shape, found, *more)
    return found.Mass()


def judge_step(tally, name, duct, file, unit):
    """The faces: surface, area, length of a section."""
    shape, faces = faces_of(file)
    tally.ok(len(faces) == 2 and BRepCheck_Analyzer(shape).IsValid(), f'{name}: two faces, valid')
    worst = 0.0
    for face in faces:
        surface = BRep_Tool.Surface_s(face)
        ends = surface.Bounds()
        for u in numpy.linspace(ends[0], ends[1], 31):
            for v in numpy.linspace(ends[2], ends[3], 31):
                p = surface.Value(u, v)
                wanted = unit*duct.at(numpy.array([u]), v*duct.t[-1])[0]
                worst = max(worst, numpy.linalg.norm(numpy.array([p.X(), p.Y(), p.Z()]) - wanted))
    tally.ok(worst <= 1e-10*unit, f'{name}: the surface is scipy\'s: {worst/unit:.1e}')
    area = mass(BRepGProp.SurfaceProperties_s, shape, 1e-9)/unit**2
    tally.ok(abs(area - duct.skin()) <= 1e-7*area, f'{name}: its area {area:.6f}')
    station = 0.4*duct.stations[0] + 0.6*duct.stations[-1]
    section = BRepAlgoAPI_Section(shape, gp_Pln(gp_Pnt(unit*station, 0, 0), gp_Dir(1, 0, 0)))
    section.Build()
    length = mass(BRepGProp.LinearProperties_s, section.Shape())/unit
    tally.ok(abs(length - duct.measures(station)[1]) <= 1e-5*length,
             f'{name}: the length of a section, {length:.6f}')


def main():
    """Judges a deck."""
    tally = Tally()
    deck, listing, points, file = sys.argv[1:]
    text = open(deck, encoding='utf-8').read()
    unit = {'FEET': 304.8, 'MM': 1.0}.get(re.search(r'^UNITS +(\w+)', text, re.M)[1], 25.4)
    for name, duct in ducts_of(deck).items():
        judge_listing(tally, name, duct, open(listing, encoding='utf-8').read())
        judge_points(tally, name, duct, points)
        judge_step(tally, name, duct, file, unit)
    tally.finish()


if __name__ == '__main__':
    main()
