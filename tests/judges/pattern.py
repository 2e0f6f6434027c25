"""Judges a pattern of LOFT as it comes from a printer: renders it and measures with a ruler.

    pattern.py FILE.pdf|FILE.svg --half-axes A B [--tiles] [--dpi N]

The file is of one cut that is an ellipse; A and B are its half axes in inches. Both check bars of
every page must be as long as they say; the outline must be the ellipse, on the page or, where the
pages are tiles, on all tiles laid cross on cross. Prints the Test Anything Protocol.
"""
import argparse
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image
from scipy.signal import fftconvolve

from outlines import Tally

BAR, CURVE = 0.004, 0.006       # what a ruler and pixels allow, in
STRIP = 1.4                     # the check bars are in so much of a page's foot, in
ARM = 0.2                       # half a cross, in
COARSE = 30                     # dpi at which the ellipse is looked for

Image.MAX_IMAGE_PIXELS = None


def darkness(name):
    """How black each pixel is, 0 to 1; what has a colour is not."""
    rgb = np.asarray(Image.open(name).convert('RGB'), dtype=np.float32) / 255
    return np.where(np.ptp(rgb, axis=2) < 0.1, 1 - rgb.max(axis=2), 0)


def render(name, dpi):
    """The pages of a file: (darkness, words) of each."""
    pages = []
    with tempfile.TemporaryDirectory() as folder:
        if name.endswith('.svg'):
            picture = f'{folder}/page.png'
            subprocess.run(['rsvg-convert', '-d', str(dpi), '-p', str(dpi), '-b', 'white', '-u',
                            '-o', picture, name], check=True)
            words = ' '.join(re.findall(r'<text[^>]*>([^<]*)', Path(name).read_text('utf-8')))
            return [(darkness(picture), words)]
        subprocess.run(['pdftoppm', '-r', str(dpi), '-png', name, f'{folder}/p'], check=True)
        for number, picture in enumerate(sorted(Path(folder).iterdir()), 1):
            said = subprocess.run(['pdftotext', '-f', str(number), '-l', str(number), '-layout',
                                   name, '-'], check=True, capture_output=True, text=True)
            pages.append((darkness(picture), said.stdout))
    return pages


def longest_run(row):
    """Begin and end of the longest run of black pixels."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], row > 0.25, [0]))))
    if not len(edges):
        return 0, 0
    lengths = edges[1::2] - edges[::2]
    best = lengths.argmax()
    return edges[2 * best], edges[2 * best + 1]


def centroid(values):
    """The middle of what is black."""
    return (values * np.arange(len(values))).sum() / max(values.sum(), 1e-9)


def bars(page, dpi):
    """Lengths of the check bars on a page, from the middle of the first tick to that of the last."""
    top = int(page.shape[0] - STRIP * dpi)
    found, last = [], -dpi
    for row in range(top, page.shape[0]):
        begin, end = longest_run(page[row])
        if end - begin < 1.3 * dpi or row - last < 0.1 * dpi:
            continue
        last = row
        ticks = page[row - int(0.08 * dpi):row - int(0.03 * dpi)].sum(axis=0)
        reach = int(0.04 * dpi)
        ends = [at - reach + centroid(ticks[at - reach:at + reach]) for at in (begin, end)]
        found.append((ends[1] - ends[0]) / dpi)
    return found


def judge_bars(tally, pages, dpi):
    """Compares the bars of each page with what they say."""
    worst, wrong = 0, []
    for number, (page, words) in enumerate(pages, 1):
        said = [float(value) / (2.54 if unit == 'cm' else 1) for value, unit in
                re.findall(r'MEASURE THIS: ([\d.]+) (in|cm)', words)]
        measured = bars(page, dpi)
        if len(said) != 2 or len(measured) != 2:
            wrong.append(f'page {number} says {said}, has {measured}')
            continue
        worst = max(worst, *(abs(a - b) for a, b in zip(said, measured)))
    tally.ok(not wrong, f'{len(pages)} pages, each with two check bars {"; ".join(wrong)}')
    tally.ok(worst <= BAR, f'check bars are as long as they say, {worst:.4f} in off')


def crosses(page, dpi):
    """The middles of the four crosses of a tile, in pixels: corner -> (x, y)."""
    arm, found = int(ARM * dpi) - 2, {}
    level = fftconvolve(page, np.ones((1, 2 * arm + 1), np.float32), 'same')
    upright = fftconvolve(page, np.ones((2 * arm + 1, 1), np.float32), 'same')
    score = np.minimum(level, upright)
    height, width = page.shape
    for corner, rows, columns in (('upper left', slice(0, height // 4), slice(0, width // 4)),
                                  ('lower right', slice(height // 2, None),
                                   slice(3 * width // 4, None))):
        at = np.unravel_index(score[rows, columns].argmax(), score[rows, columns].shape)
        y, x = at[0] + (rows.start or 0), at[1] + (columns.start or 0)
        near = page[y - arm:y + arm + 1, x - arm:x + arm + 1]
        found[corner] = (x - arm + centroid(near[:arm // 2].sum(axis=0)),
                         y - arm + centroid(near[:, :arm // 2].sum(axis=1)))
    return found


def join(tally, pages, dpi):
    """Lays tiles on a table, cross on cross; what is around a cut is left white."""
    table, tiles = None, []
    for page, words in pages:
        said = re.search(r'CROSSES ([\d.]+) BY ([\d.]+) in APART', words)
        name = re.search(r'(?m)^ *([A-Z])(\d+)\b', words)
        if said and name:
            tiles.append((ord(name[1]) - ord('A'), int(name[2]) - 1, page,
                          np.array([float(said[1]), float(said[2])])))
    tally.ok(len(tiles) == len(pages) - 1, f'a page map and {len(tiles)} tiles with their names')
    worst = 0
    for row, column, page, cell in tiles:
        found = crosses(page, dpi)
        start, end = np.array(found['upper left']), np.array(found['lower right'])
        worst = max(worst, np.abs((end - start) / dpi - cell).max())
        if table is None:
            table = np.zeros([int(n * dpi) + 2 for n in (cell[::-1] * 26)], np.float32)
        edge = int(0.25 * dpi)
        size = np.rint(cell * dpi).astype(int)
        to = np.rint(np.array([column, row]) * cell * dpi).astype(int)
        origin = np.rint(start).astype(int)
        part = page[origin[1] + edge:origin[1] + size[1] - edge,
                    origin[0] + edge:origin[0] + size[0] - edge]
        table[to[1] + edge:to[1] + size[1] - edge, to[0] + edge:to[0] + size[0] - edge] = part
    tally.ok(worst <= BAR, f'crosses are as far apart as the tiles say, {worst:.4f} in off')
    used = np.argwhere(table > 0.25)
    return table[:used[:, 0].max() + dpi, :used[:, 1].max() + dpi]


def find(page, axes, dpi):
    """Where on a page the middle of the ellipse is, in pixels, roughly."""
    step = dpi // COARSE
    height, width = (n // step * step for n in page.shape)
    small = page[:height, :width].reshape(height // step, step, width // step, step).max(axis=(1, 3))
    angle = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    reach = [int(a * dpi / step) + 2 for a in axes]
    mask = np.zeros((2 * reach[1] + 1, 2 * reach[0] + 1), np.float32)
    mask[np.rint(reach[1] + axes[1] * dpi / step * np.sin(angle)).astype(int),
         np.rint(reach[0] + axes[0] * dpi / step * np.cos(angle)).astype(int)] = 1
    score = fftconvolve(small, mask[::-1, ::-1], 'same')
    y, x = np.unravel_index(score.argmax(), score.shape)
    return np.array([(x + 0.5) * step, (y + 0.5) * step])


def judge_ellipse(tally, page, axes, dpi):
    """Measures the outline across itself at many places; where nothing is printed it is not seen."""
    angle = np.linspace(0, 2 * np.pi, 1440, endpoint=False)
    at = np.array([axes[0] * np.cos(angle), -axes[1] * np.sin(angle)]).T * dpi
    normal = np.array([np.cos(angle) / axes[0], -np.sin(angle) / axes[1]]).T
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    middle = find(page, axes, dpi)
    offsets = np.arange(-0.1 * dpi, 0.1 * dpi + 0.25, 0.25)
    for _ in range(4):
        places = (middle + at)[:, None, :] + offsets[None, :, None] * normal[:, None, :]
        across = sample(page, places)
        seen = across.max(axis=1) > 0.25
        off = (across * offsets).sum(axis=1) / np.maximum(across.sum(axis=1), 1e-9)
        shift = np.linalg.lstsq(normal[seen], off[seen], rcond=None)[0]
        middle = middle + shift
        offsets = np.arange(-0.03 * dpi, 0.03 * dpi + 0.25, 0.25)
    residual = np.abs(off[seen] - normal[seen] @ shift) / dpi
    share, typical, most = seen.mean(), np.median(residual), np.quantile(residual, 0.98)
    tally.ok(share > 0.75, f'the outline is the ellipse, seen on {100 * share:.0f} % of it')
    tally.ok(most <= CURVE, f'measured across: median {typical:.4f} in off, 98 % within {most:.4f}')


def sample(page, places):
    """The darkness at places between pixels; pixel 0 has its middle at 0.5."""
    x, y = places[..., 0] - 0.5, places[..., 1] - 0.5
    column = np.clip(np.floor(x).astype(int), 0, page.shape[1] - 2)
    row = np.clip(np.floor(y).astype(int), 0, page.shape[0] - 2)
    s, t = x - column, y - row
    return ((1 - t) * ((1 - s) * page[row, column] + s * page[row, column + 1]) +
            t * ((1 - s) * page[row + 1, column] + s * page[row + 1, column + 1]))


def main():
    """Reads the command line and judges."""
    parser = argparse.ArgumentParser()
    parser.add_argument('file')
    parser.add_argument('--half-axes', type=float, nargs=2, required=True, help='of the ellipse, in')
    parser.add_argument('--tiles', action='store_true', help='pages are a map and tiles')
    parser.add_argument('--dpi', type=int, default=150)
    options = parser.parse_args()
    tally = Tally()
    pages = render(options.file, options.dpi)
    judge_bars(tally, pages, options.dpi)
    whole = join(tally, pages, options.dpi) if options.tiles else pages[0][0]
    judge_ellipse(tally, whole, options.half_axes, options.dpi)
    tally.finish()


if __name__ == '__main__':
    main()
