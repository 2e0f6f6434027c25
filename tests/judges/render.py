"""Draws the faces of a STEP file as OpenCASCADE sees them, for the README.

    render.py FILE.step PICTURE.png [--width 1200]

The kernel turns the faces into triangles with normals; light, shade and hidden parts are worked
here, point by point, so that no graphics system is needed.
"""
import argparse

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_REVERSED
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS
from PIL import Image

VIEW = np.radians([-145.0, 22.0])  # azimuth and height of the eye
LIGHT = np.array([-0.10, -0.62, 0.78])
SKIN, EDGE, PAPER = (0.60, 0.70, 0.80), (0.13, 0.20, 0.30), (1.0, 1.0, 1.0)
FINER = 2  # points of the working picture in one of the final one, each way


def shapes(shape, kind):
    """The parts of a shape that are of a kind."""
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def as_array(point):
    """A point of the kernel as an array."""
    return np.array([point.X(), point.Y(), point.Z()])


def triangles_of(face):
    """Points, triangles and outward normals at the points of a face, and its edges as polygons."""
    place = TopLoc_Location()
    mesh = BRep_Tool.Triangulation_s(face, place)
    points = np.array([as_array(mesh.Node(i + 1)) for i in range(mesh.NbNodes())])
    corners = np.array([mesh.Triangle(i + 1).Get() for i in range(mesh.NbTriangles())]) - 1
    if face.Orientation() == TopAbs_REVERSED:
        corners = corners[:, ::-1]
    flat = np.cross(points[corners[:, 1]] - points[corners[:, 0]],
                    points[corners[:, 2]] - points[corners[:, 0]])
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, corners[:, corner], flat)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-30)[:, None]
    edges = []
    for edge in shapes(face, TopAbs_EDGE):
        line = BRep_Tool.PolygonOnTriangulation_s(TopoDS.Edge(edge), mesh, place)
        if line is not None:
            edges.append(points[[line.Node(i + 1) - 1 for i in range(line.NbNodes())]])
    return points, corners, normals, edges


class Picture:
    """A picture with the depth of each of its points."""

    def __init__(self, low, high, width):
        self.scale = (width - 40 * FINER) / (high - low)[0]
        size = np.ceil((high - low) * self.scale + 40 * FINER).astype(int)
        self.low = low - 20 * FINER / self.scale
        self.depth = np.full((size[1], size[0]), -np.inf)
        self.colour = np.full((size[1], size[0], 3), PAPER)

    def at(self, seen):
        """Where points are in the picture: right, down, towards the eye."""
        right = (seen[:, 0] - self.low[0]) * self.scale
        down = self.depth.shape[0] - (seen[:, 1] - self.low[1]) * self.scale
        return np.column_stack([right, down, seen[:, 2] * self.scale])

    def triangle(self, corners, shades):
        """Draws a triangle: three points, and how bright they are."""
        low = np.floor(corners[:, :2].min(axis=0)).astype(int)
        high = np.ceil(corners[:, :2].max(axis=0)).astype(int) + 1
        x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
        (ax, ay), (bx, by), (cx, cy) = corners[:, :2]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if abs(area) < 1e-12:
            return
        v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
        w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
        parts = np.stack([1 - v - w, v, w])
        depth = np.tensordot(corners[:, 2], parts, 1)
        window = np.s_[low[1]:high[1], low[0]:high[0]]
        seen = (parts.min(axis=0) >= -1e-9) & (depth > self.depth[window])
        self.depth[window][seen] = depth[seen]
        shade = np.tensordot(shades, parts, 1)[seen]
        self.colour[window][seen] = np.clip(np.outer(shade, SKIN), 0, 1)

    def line(self, points):
        """Draws a line where nothing hides it."""
        for begin, end in zip(points, points[1:]):
            steps = int(np.ceil(np.abs(end - begin)[:2].max())) + 1
            for x, y, z in np.linspace(begin, end, steps):
                spot = np.s_[int(y):int(y) + FINER, int(x):int(x) + FINER]
                self.colour[spot][self.depth[spot] < z + 1.5 * FINER] = EDGE

    def save(self, name):
        """Saves the picture, each point the mean of its finer ones."""
        rows, columns = (n // FINER * FINER for n in self.depth.shape)
        fine = self.colour[:rows, :columns].reshape(rows // FINER, FINER, columns // FINER, FINER, 3)
        image = np.round(255 * fine.mean(axis=(1, 3))).astype(np.uint8)
        Image.fromarray(image).quantize(128).save(name, optimize=True)


def main():
    """Reads, looks and draws."""
    parser = argparse.ArgumentParser()
    parser.add_argument('file')
    parser.add_argument('picture')
    parser.add_argument('--width', type=int, default=1200)
    wanted = parser.parse_args()
    reader = STEPControl_Reader()
    reader.ReadFile(wanted.file)
    reader.TransferRoots()
    shape = reader.OneShape()
    BRepMesh_IncrementalMesh(shape, 0.5, False, 0.05).Perform()
    faces = [triangles_of(TopoDS.Face(face)) for face in shapes(shape, TopAbs_FACE)]
    (ca, ch), (sa, sh) = np.cos(VIEW), np.sin(VIEW)
    axes = np.array([[-sa, ca, 0], [-sh * ca, -sh * sa, ch], [ch * ca, ch * sa, sh]])
    everything = np.vstack([points for points, *_ in faces]) @ axes.T
    picture = Picture(everything[:, :2].min(axis=0), everything[:, :2].max(axis=0),
                      wanted.width * FINER)
    for points, corners, normals, _ in faces:
        at, shades = picture.at(points @ axes.T), 0.72 + 0.5 * normals @ LIGHT
        for corner in corners:
            picture.triangle(at[corner], shades[corner])
    for *_, edges in faces:
        for edge in edges:
            picture.line(picture.at(edge @ axes.T))
    picture.save(wanted.picture)


if __name__ == '__main__':
    main()
