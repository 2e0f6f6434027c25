"""Judges an IGES file of LOFT: its cards by hand, its shapes by OpenCASCADE.

    iges.py FILE [--unit MM] [--count 126=13] [--csv CUTS.csv --within D] [--same OTHER.igs] ...

Prints the Test Anything Protocol; ends with status 1 where a check fails. All lengths of the
command line are in the unit of the file, of which --unit says how many millimetres it has:
OpenCASCADE reads into millimetres, so that a wrong unit of the file is seen.
"""
import argparse
import re
from collections import Counter

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepBuilderAPI import BRepBuilderAPI_Sewing
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.GeomAbs import GeomAbs_BSplineCurve
from OCP.gp import gp_Pnt
from OCP.IFSelect import IFSelect_RetDone
from OCP.IGESControl import IGESControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SHELL
from OCP.TopoDS import TopoDS
from scipy.interpolate import BSpline

from outlines import Tally, read_cuts
from step import area, compound, distance, free_edges, listed, parts, volume

CURVES = (104, 110, 126)
ROOTS = (*CURVES, 116, 128, 144)
CLOSE = 1e-9


class Deck:
    """The sections of a file, read by the columns of its cards."""

    def __init__(self, text):
        self.cards = text.split('\n')[:-1]
        self.sections = {letter: [card for card in self.cards if card[72:73] == letter]
                         for letter in 'SGDPT'}
        self.facts, self.broken = values(card[:72] for card in self.sections['G'])
        self.entities = [self.entity(first) for first in
                         range(0, len(self.sections['D']), 2)]

    def entity(self, first):
        """Directory and parameters of an entity, by the place of its first directory card."""
        cards = self.sections['D'][first:first + 2]
        entry = [card[column:column + 8].strip() for card in cards for column in range(0, 72, 8)]
        begin, count = int(entry[1]) - 1, int(entry[12])
        cards = self.sections['P'][begin:begin + count]
        record, broken = values(card[:64] for card in cards)
        self.broken += broken
        pointers = {int(card[64:72]) for card in cards}
        return {'pointer': first + 1, 'type': int(entry[0]), 'level': int(entry[4]),
                'form': int(entry[13]), 'record': record, 'stands': entry[8][2:4] == '00',
                'sound': entry[0] == entry[9] == record[0] and pointers == {first + 1}}


def values(cards):
    """The values of a record in free format, and how many numbers were broken by a card's end."""
    found, word, left, broken = [], '', 0, 0
    for card in cards:
        for place, letter in enumerate(card):
            if left:
                word, left = word + letter, left - 1
                continue
            if letter == 'H' and re.fullmatch(r'\d+', word):
                left, word = int(word), 'H'
            elif letter in ',;':
                found.append(word[1:] if word[:1] == 'H' else word)
                word = ''
                if letter == ';':
                    return found, broken
            elif letter != ' ':
                broken += place == len(card) - 1
                word += letter
    raise ValueError('a record has no end')


def number(word):
    """A real, which must have a point."""
    assert '.' in word, word
    return float(word.replace('D', 'e'))


def spline_of(record):
    """Homogeneous spline and weights of a 126."""
    last, degree = int(record[1]), int(record[2])
    reals = [number(word) for word in record[7:7 + (last + degree + 2) + 4 * (last + 1) + 5]]
    knots, reals = reals[:last + degree + 2], reals[last + degree + 2:]
    weights = np.array(reals[:last + 1])
    poles = np.reshape(reals[last + 1:4 * (last + 1)], (last + 1, 3))
    ends = reals[4 * (last + 1):4 * (last + 1) + 2]
    assert ends == [knots[0], knots[-1]]
    poles = np.hstack([weights[:, None] * poles, weights[:, None]])
    return BSpline(knots, poles, degree), weights


def points_of(spline, count):
    """Points along a homogeneous spline."""
    at = spline(np.linspace(spline.t[0], spline.t[-1], count))
    return at[:, :3] / at[:, 3:]


def judge_cards(tally, deck, wanted):
    """What can be seen on the cards."""
    tally.ok(all(len(card.encode()) == 80 for card in deck.cards), 'every card has 80 columns')
    order = ''.join(card[72] for card in deck.cards)
    tally.ok(re.fullmatch('S+G+D+P+T', order), 'the sections are in order')
    tally.ok(all(int(card[73:80]) == i + 1 for cards in deck.sections.values()
                 for i, card in enumerate(cards)), 'the cards of each are numbered')
    counts = ''.join(f'{letter}{len(deck.sections[letter]):7}' for letter in 'SGDP')
    tally.ok(deck.sections['T'][0][:72] == counts.ljust(72), 'the last card has their counts')
    tally.ok(deck.broken == 0, 'no number is broken')
    tally.ok(all(entity['sound'] for entity in deck.entities),
             f'directory and parameters agree on {len(deck.entities)} entities')
    tally.ok(len(deck.facts) == 26 and deck.facts[22] == '11', '26 facts, of IGES 5.3')
    flags = {25.4: ('1', 'IN'), 304.8: ('4', 'FT'), 1.0: ('2', 'MM'), 1000.0: ('6', 'M')}
    tally.ok(tuple(deck.facts[13:15]) == flags[wanted.unit], f'the unit is {deck.facts[14]}')
    tally.ok(deck.facts[17] == deck.facts[24] == '19700101.000000', 'there is no date in it')


def transfer(reader, deck):
    """The shape of each entity that stands for itself, by its place in the deck."""
    roots = [i for i, entity in enumerate(deck.entities)
             if entity['type'] in ROOTS and entity['stands']]
    assert reader.NbRootsForTransfer() == len(roots)
    shapes = {}
    for number, place in enumerate(roots, 1):
        reader.ClearShapes()
        if reader.TransferOneRoot(number):
            shapes[place] = reader.OneShape()
    return shapes


def judge_curves(tally, deck, shapes, wanted):
    """The kernel's curves are those of the file: points on them, ends, weights."""
    off = most = kept = 0
    for i, shape in shapes.items():
        if deck.entities[i]['type'] != 126:
            continue
        spline, weights = spline_of(deck.entities[i]['record'])
        points = points_of(spline, 25) * wanted.unit
        most = max(most, np.abs(points).max())
        off = max(off, max(distance(shape, point) for point in points))
        edges = parts(shape, TopAbs_EDGE)
        curve = BRepAdaptor_Curve(TopoDS.Edge(edges[0]))
        if len(edges) == 1 and curve.GetType() == GeomAbs_BSplineCurve:
            read = curve.BSpline()
            read = np.array([read.Weight(k + 1) for k in range(read.NbPoles())])
            kept += len(read) == len(weights) and np.allclose(read, weights, rtol=CLOSE)
        else:
            kept += len(edges) > 1
    count = sum(deck.entities[i]['type'] == 126 for i in shapes)
    tally.ok(off <= CLOSE * max(most, 1),
             f'{count} splines are where they were, within {off:.1e} mm')
    tally.ok(kept == count, 'with their weights')


def judge_same(tally, deck, shapes, wanted):
    """The curves of another file, which has splines, are those of this one."""
    other = Deck(open(wanted.same, encoding='latin-1').read())
    theirs = [e for e in other.entities if e['type'] == 126 and e['stands']]
    ours = [i for i in shapes if deck.entities[i]['type'] in CURVES]
    tally.ok(len(ours) == len(theirs), f'{wanted.same} has as many curves')
    off, most, places = {}, {}, {}
    for i, entity in zip(ours, theirs):
        points = points_of(spline_of(entity['record'])[0], 25) * wanted.unit
        key = deck.entities[i]['type'], deck.entities[i]['form']
        off[key] = max(off.get(key, 0), max(distance(shapes[i], point) for point in points))
        most[key] = max(most.get(key, 1), np.abs(points).max())
        curve = BRepAdaptor_Curve(TopoDS.Edge(parts(shapes[i], TopAbs_EDGE)[0]))
        begin = curve.Value(curve.FirstParameter())
        places[key] = max(places.get(key, 0), begin.Distance(gp_Pnt(*map(float, points[0]))))
        if key[0] == 104:
            end = curve.Value(curve.LastParameter())
            places[key] = max(places[key], end.Distance(gp_Pnt(*map(float, points[-1]))))
    for key in sorted(off):
        tally.ok(off[key] <= CLOSE * most[key],
                 f'{key[0]}, form {key[1]}: the same curves within {off[key]:.1e} mm')
        tally.ok(places[key] <= CLOSE * most[key], 'they begin and end where they should')


def cut_points(name):
    """Number and points of each cut of a CSV file."""
    return [(cut, np.concatenate(stretches))
            for cut, (_, stretches) in read_cuts(name, 1.0).items()]


def judge_points(tally, deck, shapes, wanted):
    """Points of cuts are on the curves of their level."""
    for level, points in cut_points(wanted.csv):
        curves = compound([shape for i, shape in shapes.items()
                           if deck.entities[i]['level'] == level])
        off = max(distance(curves, point) for point in points * wanted.unit) / wanted.unit
        tally.ok(off <= wanted.within, f'level {level}: {len(points)} points within {off:.1e}')


def judge_skin(tally, shapes, wanted):
    """The faces can be sewn, and measure what they should."""
    faces = [face for shape in shapes.values() for face in parts(shape, TopAbs_FACE)]
    if wanted.faces is not None:
        tally.ok(len(faces) == wanted.faces, f'faces: {len(faces)}')
    if wanted.free is not None:
        sewing = BRepBuilderAPI_Sewing(1e-6 * wanted.unit)
        for face in faces:
            sewing.Add(face)
        sewing.Perform()
        shells = parts(sewing.SewedShape(), TopAbs_SHELL)
        found = sum(len(free_edges(shell)) for shell in shells)
        tally.ok(found == wanted.free, f'sewn, free edges: {found}')
        if wanted.volume is not None:
            found = abs(sum(volume([shell]) for shell in shells)) / wanted.unit**3
            tally.ok(abs(found / wanted.volume - 1) <= wanted.relative, f'volume {found:.10g}')
    if wanted.area is not None:
        found = area(faces) / wanted.unit**2
        tally.ok(abs(found / wanted.area - 1) <= wanted.relative, f'area {found:.10g}')
    if wanted.skin:
        for cut, points in cut_points(wanted.skin):
            off = max(distance(compound(faces), point)
                      for point in points * wanted.unit) / wanted.unit
            tally.ok(off <= wanted.within, f'cut {cut} is on the skin within {off:.1e}')


def arguments():
    """The command line."""
    parser = argparse.ArgumentParser(description='Judges an IGES file by OpenCASCADE.')
    parser.add_argument('file')
    parser.add_argument('--unit', type=float, default=25.4, help='millimetres of the unit')
    parser.add_argument('--count', action='append', default=[], help='TYPE=HOW MANY')
    parser.add_argument('--csv', help='CSV of points of the cuts')
    parser.add_argument('--skin', help='CSV of points of the skin')
    parser.add_argument('--within', type=float, help='distance allowed of points')
    parser.add_argument('--same', help='the same drawing, with splines for conics')
    for name in ('faces', 'free'):
        parser.add_argument('--' + name, type=int, help='how many')
    for name in ('area', 'volume'):
        parser.add_argument('--' + name, type=float)
    parser.add_argument('--relative', type=float, default=1e-6, help='of area and volume')
    return parser.parse_args()


def main():
    """Reads and judges."""
    wanted, tally = arguments(), Tally()
    deck = Deck(open(wanted.file, encoding='latin-1', newline='\n').read())
    judge_cards(tally, deck, wanted)
    reader = IGESControl_Reader()
    tally.ok(reader.ReadFile(wanted.file) == IFSelect_RetDone, f'{wanted.file} can be read')
    found = listed(reader.WS().ModelCheckList())
    tally.ok(not found, f'without complaint {found[:3]}')
    kinds = Counter(entity['type'] for entity in deck.entities)
    tally.ok(reader.IGESModel().NbEntities() == len(deck.entities), 'all entities are known')
    for kind, count in (map(int, words.split('=')) for words in wanted.count):
        tally.ok(kinds[kind] == count, f'{kinds[kind]} of type {kind}')
    shapes = transfer(reader, deck)
    tally.ok(all(BRepCheck_Analyzer(shape).IsValid() for shape in shapes.values()),
             f'BRepCheck finds no fault in {len(shapes)} shapes')
    judge_curves(tally, deck, shapes, wanted)
    if wanted.same:
        judge_same(tally, deck, shapes, wanted)
    if wanted.csv:
        judge_points(tally, deck, shapes, wanted)
    judge_skin(tally, shapes, wanted)
    tally.finish()


if __name__ == '__main__':
    main()
