"""Judges a mesh (STL, OBJ) with trimesh and prints TAP.

    mesh.py FILE [--open] [--volume V] [--relative R] [--bodies N] [--symmetric]

A closed mesh must be watertight, its triangles turned one way, outward, its volume above zero and,
where one is given, within the relative difference of it; its Euler number 2 for each body. An open
one must not be watertight. No triangle may be degenerate. A symmetric one must be its own mirror
image in the plane of x and z, to the last bit.
"""
import argparse

import numpy
import trimesh

from outlines import Tally


def load(path):
    """The mesh of a file, vertices of one position made one, to the last bit."""
    raw = trimesh.load(path, process=False, force='mesh')
    points, number = numpy.unique(raw.vertices, axis=0, return_inverse=True)
    return trimesh.Trimesh(points, number.reshape(-1)[raw.faces], process=False)


def rows(faces):
    """Corner positions of faces, each face begun at its least corner, in order."""
    turned = [numpy.roll(f, -int(numpy.lexsort(f.T[::-1])[0]), axis=0) for f in faces]
    flat = numpy.array(turned).reshape(len(faces), 9)
    return flat[numpy.lexsort(flat.T[::-1])]


def is_mirrored(mesh):
    """True where the mirror images of all triangles are its triangles."""
    faces = mesh.vertices[mesh.faces]
    image = faces[:, ::-1, :] * [1, -1, 1] + 0.0
    return numpy.array_equal(rows(faces + 0.0), rows(image))


def judge(tally, mesh, wanted):
    """All checks of a mesh."""
    tally.ok(len(mesh.faces) > 0, f'{len(mesh.faces)} triangles')
    count = numpy.unique(mesh.edges_sorted, axis=0, return_counts=True)[1]
    tally.ok(count.max() <= 2, 'no edge belongs to more than two triangles')
    tally.ok(mesh.is_winding_consistent, 'triangles are turned one way')
    if wanted.open:
        tally.ok(not mesh.is_watertight, 'the mesh is open')
    else:
        tally.ok(mesh.is_watertight, 'the mesh is watertight')
        tally.ok(mesh.volume > 0, 'it is outside out', f'volume {mesh.volume}')
        tally.ok(mesh.euler_number == 2 * wanted.bodies, 'it has no handle and no loose face',
                 f'Euler number {mesh.euler_number}')
    if wanted.volume:
        off = mesh.volume / wanted.volume - 1
        tally.ok(abs(off) <= wanted.relative, f'volume within {wanted.relative:g}',
                 f'{mesh.volume} is off by {off:.3g}')
    tally.ok(mesh.area_faces.min() > 0, 'no triangle has no area')
    if wanted.symmetric:
        tally.ok(is_mirrored(mesh), 'it is its own mirror image to the last bit')


def main():
    """Reads the command line."""
    parser = argparse.ArgumentParser()
    parser.add_argument('file')
    parser.add_argument('--open', action='store_true')
    parser.add_argument('--volume', type=float)
    parser.add_argument('--relative', type=float, default=1e-3)
    parser.add_argument('--bodies', type=int, default=1)
    parser.add_argument('--symmetric', action='store_true')
    wanted = parser.parse_args()
    tally = Tally()
    judge(tally, load(wanted.file), wanted)
    tally.finish()


main()
