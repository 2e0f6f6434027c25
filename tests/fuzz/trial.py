"""One trial: a deck through a command of LOFT, and all that must hold of it."""
import os
import random
import resource
import signal
import subprocess

import bodies
import oracle
import tables

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
#: @ begins a name in the folder of the trial; < stands for the deck on standard input.
RUNS = [['run', '--format', 'csv']]*6 + [['run', '--format', 'csv', '<']]
OTHERS = [['run'], ['run', '--arithmetic', 's360'], ['run', '-o', '@table'], ['check'], ['check', '<'],
          ['plot', '-o', '@plots', '--format', 'svg']]
EXPORTS = [['export', '-o', '@file.' + ending] for ending in
           'svg pdf dxf igs step stl obj nc hrm wgs csv'.split()] + [
    ['export', '-o', '@file.' + words[0], *words[1:]] for words in (
        'dxf --dxf-splines', 'dxf --arcs', 'dxf --3d', 'nc --arcs', 'svg --bevel 1.', 'stl --binary',
        'igs --iges-conics', 'pdf --paper a4', 'svg --sheet each --half', 'step --open')
    for words in (words.split(),)] + [['export', '-o', '-', '--format', 'dxf']]
AUDITS = [['audit', '--format', form] for form in ('listing', 'csv', 'csv', 'deck', 'deck')] + [
    ['audit', '-o', '@figures', '<'], ['plot', '-o', '@plots', '--format', 'png'], ['check']]
SWEEPS = [['sweep', '-o', '@sweep']]*3 + [
    ['sweep'], ['sweep', '-o', '@sweep', '--plot'], ['sweep', '--variant', '2'], ['run'], ['check']]
#: Seconds of processor that an input may take, bytes of memory and of output. A sweep takes as long
#: as its deck asks for: it is stopped, and must be ready to be resumed. So do calls of the library.
SECONDS, SWEEP_SECONDS, MEMORY, OUTPUT = 60, 8, 4 << 30, 1 << 28


def command_for(rng, lines):
    """A command that suits a deck, mostly."""
    kind = b'conic'
    for line in lines:
        if line[:4] == b'VARY':
            kind = b'sweep'
        if line[:5] in (b'AUDIT', b'table'):
            kind = b'audit'
    suited = {b'audit': AUDITS, b'sweep': SWEEPS}.get(kind, RUNS)
    chance = rng.random()
    if chance < .45 or kind != b'conic' and chance < .8:
        return rng.choice(suited)
    return rng.choice(rng.choice([OTHERS, EXPORTS, EXPORTS]) if chance < .97 else AUDITS + SWEEPS)


def limits(program, command):
    """Called in the new process: bounds of time, memory and output."""
    seconds = SWEEP_SECONDS if command[0] in ('sweep', 'library') else SECONDS

    def set_limits():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
        resource.setrlimit(resource.RLIMIT_FSIZE, (OUTPUT, OUTPUT))
        if 'sanitize' not in program:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    return set_limits


def spent():
    """Seconds of processor that runs have taken so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def environment(folder, deck):
    """That of a run: no gnuplot, one thread or two."""
    return dict(os.environ, PATH=os.path.join(folder, 'none'), LC_ALL='C',
                OMP_NUM_THREADS=str(1 + len(deck) % 2), LOFT_PLOT=os.path.join(ROOT, 'plot'),
                ASAN_OPTIONS='detect_leaks=0', UBSAN_OPTIONS='print_stacktrace=1')


def run(program, command, deck, folder):
    """Status, output, messages and time of a run; status None: it did not end."""
    path = os.path.join(folder, 'deck')
    with open(path, 'wb') as file:
        file.write(deck)
    words = command[1:] if command[0] == 'library' else [
        word.replace('@', folder + '/') if word.startswith('@') else word for word in command]
    source = path if words[-1] == '<' else os.devnull
    words = words[:-1] + ['-'] if words[-1] == '<' else words + [path]
    start = spent()
    with open(os.path.join(folder, 'out'), 'wb') as out, open(source, 'rb') as given, \
            open(os.path.join(folder, 'err'), 'wb') as err:
        try:
            status = subprocess.run([program, *words], stdin=given, stdout=out, stderr=err,
                                    timeout=20*SECONDS, env=environment(folder, deck), cwd=folder,
                                    preexec_fn=limits(program, command), check=False).returncode
        except subprocess.TimeoutExpired:
            status = None
    taken = spent() - start
    if status == -signal.SIGXCPU and command[0] not in ('sweep', 'library'):
        status = None
    with open(os.path.join(folder, 'out'), 'rb') as out, \
            open(os.path.join(folder, 'err'), 'rb') as err:
        return status, out.read(OUTPUT), err.read(1 << 22), taken


def without_gnuplot(status, err):
    """Status and messages of what would have been drawn: there is no gnuplot."""
    if status != 2 or b'no gnuplot is found' not in err:
        return status, err
    err = b'\n'.join(line for line in err.split(b'\n') if not line.startswith(b'loft: no gnuplot'))
    return (1 if b': error: ' in err else 0), err


def judge(program, command, deck, folder, tally=None):
    """What is wrong with a trial, as a list of words."""
    status, out, err, taken = run(program, command, deck, folder)
    if tally is not None:
        tally['slowest'] = max(tally['slowest'], (taken, ' '.join(command)))
        tally['status', status] = tally.get(('status', status), 0) + 1
        tally['command', command[0]] = tally.get(('command', command[0]), 0) + 1
    if status is None:
        return [f'no end within {SECONDS:g} s']
    if command[0] == 'library':
        return library_end(status, out, err)
    if command[0] == 'sweep' and status == -signal.SIGXCPU:
        return stopped(program, command, deck, folder)
    if '--plot' in command or command[0] == 'plot':
        status, err = without_gnuplot(status, err)
    wrong = oracle.ending(status, err) if command[0] != 'sweep' else \
        tables.sweep_ending(status, folder, out, err)
    left = [name for name in os.listdir(folder) if '.part' in name]
    if left:
        wrong.append('left ' + ' '.join(left))
    if command[0] in ('run', 'audit'):
        wrong += oracle.words(out)
    if command[0] == 'sweep' and '--variant' not in command and status in (0, 1):
        wrong += tables.sweep_rows(folder, out)
    if command[0] == 'audit' and status == 0:
        wrong += again(program, command, out, folder, tally)
    if command[:3] == RUNS[0]:
        wrong += points(deck, out, tally)
    return wrong


def library_end(status, out, err):
    """Complaints about calls of the library."""
    wrong = ['library: ' + out.decode().strip()] if status == 1 and out else []
    if status not in (0, 1, -signal.SIGXCPU) or oracle.REPORTS.search(err):
        wrong += [f'library: status {status}'] + oracle.ending(0, err)
    return wrong


def points(deck, out, tally):
    """Complaints about points that are not where the cards say."""
    judge_points = oracle.conic_points if out.startswith(b'card,') else bodies.cut_points
    off, judged = judge_points(deck, out)
    if tally is not None:
        tally['points'] += judged
        tally['rows'] += out.count(b'\n')
    return off


def stopped(program, command, deck, folder):
    """Complaints about a sweep that was stopped: nothing is named as a result; it is gone on with."""
    names = set(os.listdir(folder))
    if '-o' not in command:
        return []
    if 'sweep' in names or 'sweep.best.crd' in names:
        return ['a result of a sweep that was stopped']
    if 'sweep.partial' not in names:
        return ['no journal of a sweep that was stopped']
    status, _, err, _ = run(program, [*command, '--resume'], deck, folder)
    if status not in (0, 1, -signal.SIGXCPU) or b'loft: ' in err and status != -signal.SIGXCPU:
        return [f'not resumed, status {status}: {err[:60]}']
    return []


def again(program, command, out, folder, tally):
    """Complaints about what an audit made: its CSV audited again, its deck run."""
    if 'csv' in command and b'\n' in out.strip():
        status, twice, err, _ = run(program, command, out, folder)
        if status not in (0, 1):
            return [f'its CSV is not audited, status {status} {err.split(b": ", 1)[-1][:60]}']
        if tables.differing(out, twice):
            return ['audited again: ' + tables.differing(out, twice)]
    if 'deck' in command and any(line[:1] in b'-.0123456789' for line in out.split(b'\n') if line):
        status, table, err, _ = run(program, RUNS[0], out, folder)
        if status != 0:
            return [f'its deck does not run, status {status} {err.split(b": ", 1)[-1][:60]}']
        return points(out, table, tally)
    return []


def thinned(rng, lines):
    """Long decks with few of their cuts, mostly: the others take their time and find nothing more."""
    cuts = [i for i, line in enumerate(lines)
            if line[:7].rstrip(b', ') in (b'STATION', b'BUTTOCK', b'WATERLN', b'OBLIQUE', b'PLANE', b'CHECK')]
    if len(cuts) < 4 or rng.random() < .1:
        return lines
    kept = set(rng.sample(cuts, 3))
    return [line for i, line in enumerate(lines) if i in kept or i not in cuts]


def seeds():
    """Decks to begin with, as lists of cards: small ones, and those of cards/."""
    decks = []
    for folder in (os.path.join(HERE, 'seeds'), os.path.join(HERE, 'found'), os.path.join(ROOT, 'cards')):
        names = sorted(name for name in os.listdir(folder) if name.endswith(('.crd', '.csv')))
        decks.append([])
        for name in names:
            with open(os.path.join(folder, name), 'rb') as file:
                decks[-1].append(file.read().split(b'\n')[:-1])
    return decks


def seed_of(rng, decks):
    """One deck, thinned, and another to take cards from."""
    small, found, cards = decks
    one = rng.choice(rng.choice([small, small, small + found, cards]))
    other = rng.choice(small + cards)
    return thinned(rng, one), other


def generator(seed, number):
    """The generator of one input."""
    return random.Random(f'{seed} {number}')
