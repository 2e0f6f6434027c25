"""What judges of outlines share: a tally, the cuts of a CSV file, distances from polygons."""
import csv
import sys

import numpy as np

AXES = {'station': (1, 2), 'buttock': (0, 2), 'waterline': (0, 1)}


class Tally:
    """Checks so far, in the Test Anything Protocol."""

    def __init__(self):
        self.run = self.failed = 0

    def ok(self, passed, name, note=''):
        """Counts a check."""
        self.run += 1
        self.failed += not passed
        print(f'{"ok" if passed else "not ok"} {self.run} - {name}')
        if note and not passed:
            print(f'# {note}')

    def finish(self):
        """Prints the plan and ends."""
        print(f'1..{self.run}')
        sys.exit(1 if self.failed or not self.run else 0)


def read_cuts(name, factor):
    """The cuts of a CSV file: number -> (kind, list of stretches of points STA, BL, WL)."""
    cuts, last = {}, None
    with open(name, newline='') as file:
        for row in csv.DictReader(file):
            key = row['cut'], row['section']
            kind, stretches = cuts.setdefault(int(row['cut']), (row['kind'], []))
            if key != last:
                stretches.append([])
            last = key
            stretches[-1].append([factor * float(row[c]) for c in ('sta', 'bl', 'wl')])
    return {n: (kind, [np.array(s) for s in found]) for n, (kind, found) in cuts.items()}


def linked(stretches):
    """Stretches and the short chords between the end of one and the begin of the next."""
    longest = max(np.linalg.norm(np.diff(s, axis=0), axis=1).max(initial=0) for s in stretches)
    links = []
    for before, after in zip(stretches[-1:] + stretches, stretches):
        if np.linalg.norm(after[0] - before[-1]) <= 2 * longest:
            links.append(np.array([before[-1], after[0]]))
    return stretches + links


def distances(points, lines):
    """The distance of each point from the nearest of the straight pieces of polygons."""
    best = np.full(len(points), np.inf)
    for line in lines:
        begin, along = line[:-1], np.diff(line, axis=0)
        if len(line) == 1:
            begin, along = line, np.zeros_like(line)
        square = np.maximum((along * along).sum(axis=1), 1e-300)
        for i, point in enumerate(points):
            way = point - begin
            part = np.clip((way * along).sum(axis=1) / square, 0, 1)
            off = np.linalg.norm(way - part[:, None] * along, axis=1)
            best[i] = min(best[i], off.min())
    return best


def in_file(kind, points, in_space):
    """Points of space as a file has them: as they are, or two of their ordinates."""
    return points if in_space else points[:, AXES[kind]]


def compare(tally, cuts, drawn, options):
    """Compares each cut with what was drawn of it: number -> list of polygons.

    Points of the CSV must be on the drawing, and points of the drawing within the chords of the
    CSV, on either side of BL 0.
    """
    for number, (kind, stretches) in cuts.items():
        if number not in drawn or (kind not in AXES and not options.space):
            continue
        points = np.vstack(stretches)
        there = distances(in_file(kind, points, options.space), drawn[number]).max()
        tally.ok(there <= options.within,
                 f'cut {number}: points of the table are on it, {there:.2e} off')
        mirror = np.array([1, -1, 1])
        chords = [in_file(kind, m * s, options.space)
                  for s in linked(stretches) for m in (1, mirror)]
        back = max(distances(line, chords).max() for line in drawn[number])
        tally.ok(back <= options.back, f'cut {number}: it is on the table, {back:.2e} off')


def add_options(parser):
    """Options that judges of outlines have in common."""
    parser.add_argument('file')
    parser.add_argument('--csv', required=True, help='the cuts, loft run --format csv')
    parser.add_argument('--factor', type=float, default=1, help='units of the file in one of CSV')
    parser.add_argument('--within', type=float, required=True, help='tolerance, unit of the file')
    parser.add_argument('--back', type=float, default=np.inf, help='the same of the other way')
    parser.add_argument('--cuts', type=int, help='how many cuts there must be')
