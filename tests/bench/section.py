"""Times OpenCASCADE's section of an exported skin by planes, beside LOFT's cut of the same body.

    section.py FILE.step TURNS X,Y,Z,NX,NY,NZ ...

A plane is a point in millimetres and a normal. Prints the seconds of the processor of each
turn, a line a plane.
"""
import sys
import time

from OCP.BRepAlgoAPI import BRepAlgoAPI_Section
from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
from OCP.STEPControl import STEPControl_Reader

reader = STEPControl_Reader()
reader.ReadFile(sys.argv[1])
reader.TransferRoots()
shape = reader.OneShape()
for words in sys.argv[3:]:
    number = [float(word) for word in words.split(',')]
    plane = gp_Pln(gp_Pnt(*number[:3]), gp_Dir(*number[3:]))
    seconds = []
    for _ in range(int(sys.argv[2])):
        begin = time.process_time()
        section = BRepAlgoAPI_Section(shape, plane, False)
        section.Build()
        seconds.append(time.process_time() - begin)
        if not section.IsDone():
            sys.exit('no section')
    print(*seconds)
