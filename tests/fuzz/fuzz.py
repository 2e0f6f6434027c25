#!/usr/bin/env python3
"""Breaks LOFT, or fails to: spoiled decks through its commands, judged by what must always hold.

    fuzz.py [--minutes M] [--seed S] [--count N] [--keep DIR] [--jobs J] PROGRAM...

Each input is made from the seed and its number alone, goes through one command, and is judged by
oracle.py and bodies.py. What fails is kept in DIR with its command, its cards lessened to those
that matter. Status 1 where anything was found. Needs nothing but Python 3.8.
"""
import argparse
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import bodies
import mutate
import oracle

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
COMMANDS = [['run', '--format', 'csv']]*8 + [
    ['run'], ['run'], ['run', '--arithmetic', 's360'], ['check'], ['check'],
    ['plot', '-o', '@plots', '--format', 'svg']] + [
    ['export', '-o', '@file.' + ending] for ending in
    'svg pdf dxf igs step stl obj nc hrm wgs csv'.split()] + [
    ['export', '-o', '@file.dxf', '--dxf-splines'], ['export', '-o', '@file.dxf', '--arcs'],
    ['export', '-o', '@file.nc', '--arcs'], ['export', '-o', '@file.svg', '--bevel', '1.']]
#: Seconds of processor that an input may take, and bytes of memory and of output.
SECONDS, MEMORY, OUTPUT = 60, 4 << 30, 1 << 28


def limits(program):
    """Called in the new process: bounds of memory and output."""
    def set_limits():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))
        resource.setrlimit(resource.RLIMIT_FSIZE, (OUTPUT, OUTPUT))
        if 'sanitize' not in program:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    return set_limits


def spent():
    """Seconds of processor that runs have taken so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(program, command, deck, folder):
    """Status, output, messages and time of a run; status None: it did not end."""
    path = os.path.join(folder, 'deck')
    with open(path, 'wb') as file:
        file.write(deck)
    words = [word.replace('@', folder + '/') if word.startswith('@') else word for word in command]
    environment = dict(os.environ, PATH=os.path.join(folder, 'none'), OMP_NUM_THREADS='1',
                       LOFT_PLOT=os.path.join(ROOT, 'plot'), LC_ALL='C',
                       ASAN_OPTIONS='detect_leaks=0', UBSAN_OPTIONS='print_stacktrace=1')
    start = spent()
    with open(os.path.join(folder, 'out'), 'wb') as out, \
            open(os.path.join(folder, 'err'), 'wb') as err:
        try:
            status = subprocess.run([program, *words, path], stdin=subprocess.DEVNULL, stdout=out,
                                    stderr=err, timeout=20*SECONDS, env=environment, cwd=folder,
                                    preexec_fn=limits(program), check=False).returncode
        except subprocess.TimeoutExpired:
            status = None
    taken = spent() - start
    if status == -signal.SIGXCPU:
        status = None
    with open(os.path.join(folder, 'out'), 'rb') as out, \
            open(os.path.join(folder, 'err'), 'rb') as err:
        return status, out.read(OUTPUT), err.read(1 << 22), taken


def judge(program, command, deck, folder, tally=None):
    """What is wrong with a run, as a list of words."""
    status, out, err, taken = run(program, command, deck, folder)
    if tally is not None:
        tally['slowest'] = max(tally['slowest'], (taken, ' '.join(command)))
        tally['status', status] = tally.get(('status', status), 0) + 1
    if status is None:
        return [f'no end within {SECONDS:g} s']
    if status == 2 and command[0] == 'plot' and b'no gnuplot is found' in err:
        err = b'\n'.join(l for l in err.split(b'\n') if not l.startswith(b'loft: no gnuplot'))
        status = 1 if b': error: ' in err else 0
    wrong = oracle.ending(status, err)
    left = [name for name in os.listdir(folder) if '.part' in name]
    if left:
        wrong.append('left ' + ' '.join(left))
    if command[0] == 'run':
        wrong += oracle.words(out)
    if 'csv' in command:
        points = oracle.conic_points if out.startswith(b'card,') else bodies.cut_points
        off, judged = points(deck, out)
        wrong += off
        if tally is not None:
            tally['points'] += judged
            tally['rows'] += out.count(b'\n')
    return wrong


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
            wrong = judge(program, command, b'\n'.join(less), folder)
            if any(sort_of(w) == sort for w in wrong):
                lines, found = less, True
            else:
                at += step
        if not found or step > 1:
            step //= 2
    return b'\n'.join(lines)


def seeds():
    """Decks to begin with, as lists of cards."""
    decks = []
    for folder in (os.path.join(HERE, 'seeds'), os.path.join(HERE, 'found')):
        for name in sorted(os.listdir(folder)):
            if name.endswith('.crd'):
                with open(os.path.join(folder, name), 'rb') as file:
                    decks.append(file.read().split(b'\n')[:-1])
    return decks


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
    parser.add_argument('program', nargs='+')
    options = parser.parse_args()
    decks, folder = seeds(), tempfile.mkdtemp(prefix='loft-fuzz-')
    tally, found, end = {'slowest': (0., ''), 'points': 0, 'rows': 0}, {}, \
        time.monotonic() + 60.*options.minutes
    number = options.first
    while time.monotonic() < end and number < options.first + options.count:
        rng = random.Random(f'{options.seed} {number}')
        deck, command = mutate.mutant(rng, decks), rng.choice(COMMANDS)
        program = os.path.abspath(options.program[number % len(options.program)])
        wrong = judge(program, command, deck, folder, tally)
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
    ends = ', '.join(f'{count} of status {status[1]}' for status, count in
                     sorted(tally.items(), key=str) if status[0] == 'status')
    print(f'# seed {options.seed}: {number - options.first} inputs ({ends}), {tally["rows"]} rows, '
          f'{tally["points"]} points judged, slowest {tally["slowest"][0]:.1f} s '
          f'({tally["slowest"][1]}), {sum(found.values())} findings')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
