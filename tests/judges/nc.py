"""Judges an NC program of LOFT: runs it as a machine would and compares where the tool went.

    nc.py FILE --csv CUTS.csv --within D [--back D] [--units in|mm] [--depth Z] [--arcs]

Prints the Test Anything Protocol; ends with status 1 where a check fails. The rules are those of
NISTIR 6556 (RS274/NGC), and what Grbl allows: lines of 79 characters, no `!`, `?`, `~` anywhere.
"""
import argparse
import math
import re

import numpy as np

from outlines import Tally, add_options, compare, read_cuts

MODES = {'G17', 'G40', 'G49', 'G80', 'G90', 'G94'}
ARC_RISE = 1e-4
# NISTIR 6556, 3.5.3: how far the ends of an arc may be from one circle.
RADIUS_TOLERANCE = {'in': 2e-4, 'mm': 2e-3}


class Machine:
    """A machine of three axes."""

    def __init__(self):
        self.at = np.array([0.0, 0.0, 1.0])
        self.units = self.feed = self.motion = None
        self.modes, self.complaints = set(), []
        self.paths, self.cut, self.stops, self.skins = {}, None, 0, 0
        self.is_inside, self.path, self.insides = False, [], []
        self.depths, self.ended = set(), False
        self.arcs, self.misses, self.turns = 0, [0.0], [0.0]

    def complain(self, block, words):
        """Keeps what is wrong with a block."""
        self.complaints.append(f'{words}: {block}')

    def run(self, block):
        """Runs a block."""
        said = re.search(r'\(CUT (\d+) ', block)
        if said:
            self.cut, self.is_inside = int(said[1]), False
        if 'SIDE OF THE SKIN)' in block:
            self.is_inside = '(INSIDE' in block
            self.skins += self.is_inside
        plain = re.sub(r'\([^()]*\)', '', block).strip()
        if not re.fullmatch(r'([A-Z][-+]?[0-9]*\.?[0-9]* ?)*', plain):
            self.complain(block, 'no words')
            return
        target, centre, moves = self.at.copy(), np.zeros(2), False
        for letter, number in re.findall(r'([A-Z])([-+.0-9]+)', plain):
            value = float(number)
            if letter == 'G':
                self.prepare(block, f'G{value:g}')
            elif letter in 'XYZ':
                target['XYZ'.index(letter)] = value
                moves = True
            elif letter in 'IJ':
                centre['IJ'.index(letter)] = value
            elif letter == 'F':
                self.feed = value
            elif letter == 'M':
                self.switch(block, int(value))
            else:
                self.complain(block, f'a word {letter}')
        if moves:
            self.move(block, target, centre)

    def prepare(self, block, word):
        """Obeys a G word."""
        if word in ('G0', 'G1', 'G2', 'G3'):
            self.motion = word
        elif word in ('G20', 'G21'):
            self.units = {'G20': 'in', 'G21': 'mm'}[word]
        elif word in MODES:
            self.modes.add(word)
        else:
            self.complain(block, f'a word {word}')

    def switch(self, block, number):
        """Obeys an M word."""
        self.stops += number == 0
        self.ended = self.ended or number == 30
        if number not in (0, 3, 5, 30):
            self.complain(block, f'a word M{number}')
        if self.at[2] <= 0:
            self.complain(block, 'switched in the stock')

    def move(self, block, target, centre):
        """Moves the tool."""
        if self.ended or self.units is None or self.modes != MODES:
            self.complain(block, 'moves before it is safe')
        across = (target[:2] != self.at[:2]).any()
        if self.motion == 'G0':
            if target[2] <= 0 or (self.at[2] <= 0 and across):
                self.complain(block, 'rapid in the stock')
        elif not self.feed or self.feed <= 0:
            self.complain(block, 'cuts without feed')
        elif self.at[2] > 0:
            if across or target[2] >= 0:
                self.complain(block, 'cuts above the stock')
            self.path = [target[:2]]
            if self.is_inside:
                self.insides.append(self.path)
            else:
                self.paths.setdefault(self.cut, []).append(self.path)
            self.depths.add(float(target[2]))
        else:
            self.path.extend(self.way(block, target[:2], centre))
        self.at = target

    def way(self, block, target, offset):
        """Points of a move in the stock."""
        if self.motion == 'G1':
            return [target]
        centre = self.at[:2] + offset
        begin, end = self.at[:2] - centre, target - centre
        first, last = math.atan2(begin[1], begin[0]), math.atan2(end[1], end[0])
        turn = (last - first) % (2 * math.pi)
        if self.motion == 'G2':
            turn -= 2 * math.pi
        self.arcs += 1
        self.misses.append(abs(np.linalg.norm(begin) - np.linalg.norm(end)))
        self.turns.append(abs(turn))
        pieces = 2 + int(abs(turn) * math.sqrt(np.linalg.norm(begin) / (8 * ARC_RISE)))
        share = np.linspace(0, 1, pieces)[1:]
        angles = first + turn * share
        radius = (np.linalg.norm(begin) * (1 - share) + np.linalg.norm(end) * share)[:, None]
        return list(centre + radius * np.column_stack([np.cos(angles), np.sin(angles)]))


def judge_text(tally, lines):
    """The characters of a program."""
    text = '\n'.join(lines)
    tally.ok(text.isascii() and not set(text) & set('!?~;\t'), 'no character that controls obey')
    tally.ok(max(map(len, lines)) <= 79, 'no line is longer than 79 characters')
    tally.ok(lines[0] == lines[-1] == '%' and text.count('%') == 2, 'it stands between %')
    tally.ok(not re.search(r'\([^)]*\(', text) and text.count('(') == text.count(')'),
             'no comment is in another')


def main():
    """Judges the file of the command line."""
    parser = argparse.ArgumentParser()
    add_options(parser)
    parser.add_argument('--units', choices=('in', 'mm'), default='in')
    parser.add_argument('--depth', type=float, help='Z of the cut')
    parser.add_argument('--arcs', action='store_true', help='it has arcs')
    options = parser.parse_args()
    options.space = False
    tally, machine = Tally(), Machine()
    with open(options.file, encoding='latin-1') as file:
        lines = file.read().splitlines()
    judge_text(tally, lines)
    for line in lines[1:-1]:
        machine.run(line)
    for complaint in machine.complaints[:5]:
        print('#', complaint)
    tally.ok(not machine.complaints, 'every block can be run')
    tally.ok(machine.units == options.units, f'its unit is {machine.units}')
    tally.ok(machine.ended and machine.at[2] > 0, 'it ends above the stock')
    if options.arcs:
        tally.ok(machine.arcs > 0, f'{machine.arcs} arcs')
        tally.ok(max(machine.misses) <= RADIUS_TOLERANCE[options.units],
                 f'both ends of an arc are on one circle, {max(machine.misses):.1e} off')
        tally.ok(max(machine.turns) <= math.pi, 'no arc turns by more than 180 degrees')
    if options.depth is not None:
        tally.ok(machine.depths == {options.depth}, f'it cuts at Z {machine.depths}')
    cuts = read_cuts(options.csv, options.factor)
    wanted = options.cuts or len(cuts)
    tally.ok(len(machine.paths) == wanted
             and machine.stops == wanted - 1 + machine.skins,
             f'{wanted} cuts, {machine.skins} of them with an inside, '
             'and a stop before each but the first')
    drawn = {n: [np.array(p) for p in paths] for n, paths in machine.paths.items()}
    compare(tally, cuts, drawn, options)
    tally.finish()


if __name__ == '__main__':
    main()
