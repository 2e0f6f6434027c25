#!/usr/bin/env python3
"""Breaks LOFT, or fails to: spoiled decks through its commands, judged by what must always hold.

    fuzz.py [--minutes M] [--seed S] [--count N] [--keep DIR] [--library CALLER] PROGRAM...

Each input is made from the seed and its number alone, goes through one command, and is judged by
trial.py. What fails is kept in DIR with its command, its cards lessened to those that matter. CALLER
is library.c, for every eighth input. Status 1 where anything was found. Needs nothing but Python 3.8.
"""
import argparse
import os
import shutil
import sys
import tempfile
import time

import mutate
import trial


def sort_of(words):
    """What two findings have in common that are one."""
    return words.split(':')[-1].strip('-0123456789. ulp').strip()[:40] if ' off its' in words \
        else words[:60]


def lessened(program, command, deck, folder, sort):
    """The deck with cards taken out as long as it fails in the same way, 60 tries at most."""
    lines, step, tries = deck.split(b'\n'), None, 0
    step = max(1, len(lines)//2)
    while step and tries < 60:
        at, found = 0, False
        while at < len(lines) and tries < 60:
            less = lines[:at] + lines[at + step:]
            tries += 1
            wrong = trial.judge(program, command, b'\n'.join(less), folder)
            if any(sort_of(w) == sort for w in wrong):
                lines, found = less, True
            else:
                at += step
        if not found or step > 1:
            step //= 2
    return b'\n'.join(lines)


def keep(place, number, program, command, deck, words):
    """Keeps a finding: the deck, and beside it how it came about."""
    os.makedirs(place, exist_ok=True)
    with open(os.path.join(place, f'{number}.crd'), 'wb') as file:
        file.write(deck)
    with open(os.path.join(place, f'{number}.txt'), 'w', encoding='utf-8') as file:
        file.write(f'{program} {" ".join(command)}\n' + '\n'.join(words) + '\n')


def main():
    """Runs until the time is over or the count is reached."""
    parser = argparse.ArgumentParser(description='Spoiled decks against LOFT.')
    parser.add_argument('--minutes', type=float, default=1.)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--first', type=int, default=0)
    parser.add_argument('--count', type=int, default=10**9)
    parser.add_argument('--keep', default='')
    parser.add_argument('--library', default='')
    parser.add_argument('program', nargs='+')
    options = parser.parse_args()
    decks, folder = trial.seeds(), tempfile.mkdtemp(prefix='loft-fuzz-')
    tally, found, end = {'slowest': (0., ''), 'points': 0, 'rows': 0}, {}, \
        time.monotonic() + 60.*options.minutes
    number = options.first
    while time.monotonic() < end and number < options.first + options.count:
        rng = trial.generator(options.seed, number)
        deck = mutate.mutant(rng, *trial.seed_of(rng, decks))
        command = trial.command_for(rng, deck.split(b'\n'))
        program = options.program[number % len(options.program)]
        if options.library and number % 8 == 7:
            program, command = options.library, ['library', str(number)]
        program = os.path.abspath(program)
        wrong = trial.judge(program, command, deck, folder, tally)
        for words in wrong[:1]:
            sort = sort_of(words)
            found[sort] = found.get(sort, 0) + 1
            if options.keep and found[sort] <= 3:
                keep(options.keep, number, program, command, deck, wrong)
                if 'no end' not in words:
                    deck = lessened(program, command, deck, folder, sort)
                keep(options.keep, number, program, command, deck, wrong)
            print(f'not ok - input {number}: {" ".join(command)}: {words}', flush=True)
        for name in os.listdir(folder):
            path = os.path.join(folder, name)
            shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
        number += 1
    shutil.rmtree(folder)
    ends, commands = (', '.join(f'{count} {words}{sort[1]}' for sort, count in
                                sorted(tally.items(), key=str) if sort[0] == kind)
                      for kind, words in (('status', 'of status '), ('command', '')))
    print(f'# seed {options.seed}: {number - options.first} inputs ({commands}; {ends}), '
          f'{tally["rows"]} rows, '
          f'{tally["points"]} points judged, slowest {tally["slowest"][0]:.1f} s '
          f'({tally["slowest"][1]}), {sum(found.values())} findings')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
