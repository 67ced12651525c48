"""Tells what ParaView makes of the series particles.pvd and grid.pvd of a folder, with pictures.

xvfb-run -a pvbatch paraview_check.py DIR
"""
import os
import sys

from paraview.simple import (
    ColorBy, CreateView, Delete, GetAnimationScene, OpenDataFile, SaveScreenshot, Show,
)


def ranges(kind, information):
    for k in range(information.GetNumberOfArrays()):
        array = information.GetArray(k)
        print(" ", kind, array.GetName(), end="")
        for component in range(array.GetNumberOfComponents()):
            print("", *array.GetRange(component), end="")
        print()


def describe(folder, name):
    source = OpenDataFile(os.path.join(folder, name))
    if source is None:
        sys.exit(f"ParaView cannot open {name}")
    for time in source.TimestepValues:
        source.UpdatePipeline(time)
        data = source.GetDataInformation()
        points, cells = data.GetNumberOfPoints(), data.GetNumberOfCells()
        print(name, "time", time, "points", points, "cells", cells)
        if points > 0:
            print("  bounds", *data.GetBounds())
            ranges("point", source.PointData)
            ranges("cell", source.CellData)
    view = CreateView("RenderView")
    view.ViewSize = [600, 400]
    GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    GetAnimationScene().GoToLast()
    shown = Show(source, view)
    if name.startswith("particles"):
        shown.Representation = "Points"
        shown.PointSize = 12
        ColorBy(shown, ("POINTS", "density"))
    else:
        shown.Representation = "Surface With Edges"
        ColorBy(shown, ("CELLS", "density"))
    view.ResetCamera()
    SaveScreenshot(os.path.join(folder, name.replace(".pvd", ".png")), view)
    Delete(source)


for series in ("particles.pvd", "grid.pvd"):
    describe(sys.argv[1], series)
