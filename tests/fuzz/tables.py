"""What must hold of the rows of a sweep and of the figures of an audit."""
import csv
import io
import os
import re

import oracle

FIRST = re.compile(r'# loft \S+ sweep of (\d+) variants, deck [0-9a-f]{64}$')


def sweep_ending(status, folder, out, err):
    """Complaints about how a sweep ended: as a run, but status 1 is also that no variant is good."""
    if status == 1 and b'o variant keeps all limits' in out:
        status = 1 if b': error: ' in err else 0
        if os.path.exists(os.path.join(folder, 'sweep.best.crd')):
            return ['a best deck where none is good']
    return oracle.ending(status, err)


def sweep_rows(folder, out):
    """Complaints about the rows of a sweep: all there, in order, each of a state that it can have."""
    path = os.path.join(folder, 'sweep')
    if os.path.exists(path):
        with open(path, 'rb') as file:
            out = file.read()
    lines = out.decode('latin-1').split('\n')
    first = FIRST.match(lines[0])
    if not first:
        return ['no first line of a sweep'] if out else []
    rows = list(csv.reader(line for line in lines[1:] if line and not line.startswith('#')))
    if len(rows) != int(first[1]) + 1:
        return [f'{len(rows) - 1} rows of {first[1]} variants']
    for number, row in enumerate(rows[1:], 1):
        if len(row) != len(rows[0]) or row[0] != str(number):
            return [f'row {number} is {row[:3]} of {len(row)} fields']
        state, front, why = row[-3:]
        if (state, bool(why)) not in (('ok', False), ('limit', True), ('fault', True)):
            return [f'state {state}, why {why[:20]}']
        if front not in ('0', '1') or front == '1' and state != 'ok':
            return [f'front {front} of state {state}']
        if oracle.BAD.search(','.join(row[1:-3]).encode()):
            return [f'row {number} prints a number that is none']
    return []


def figures(table):
    """Rows of an audit in CSV: what was printed, the verdict, the corrected figure."""
    rows = csv.DictReader(io.StringIO(table.decode('latin-1')))
    return [[row[name] for name in ('table', 'view', 'at', 'what', 'along', 'printed', 'verdict', 'corrected')]
            for row in rows]


def differing(one, two):
    """The first figure in which two audits differ, or nothing."""
    one, two = figures(one), figures(two)
    if len(one) != len(two):
        return f'{len(one)} and {len(two)} figures'
    return next((f'{a} is {b}' for a, b in zip(one, two) if a != b), '')
