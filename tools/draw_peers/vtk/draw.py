#!/usr/bin/python3
"""Draws a campus by VTK on Mesa's software driver: draw.py FOLDER

FOLDER holds campus.glb and views.json of `campuswalk-bench draw`. Prints "frame LOOK VIEW MS" for each picture,
and leaves the first view's as FOLDER/vtk-LOOK.png. Debian's VTK draws through X alone, so it gets an Xvfb.
"""

import json
import os
import subprocess
import sys
import time

# Which looks there are: name, samples a pixel, FXAA. VTK's shadows are left out: it draws their maps anew for
# every picture.
LOOKS = (("no-aa", 0, False), ("fxaa", 0, True), ("msaa4", 4, False))


def start_display():
    """A display of its own; the process that serves it."""
    ours, servers = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(servers), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
                              pass_fds=[servers], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(servers)
    with os.fdopen(ours) as told:
        os.environ["DISPLAY"] = ":" + told.readline().strip()
    return server


def make_window(vtk, views, samples):
    """A window that isn't shown."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(samples)
    window.SetSize(views["width"], views["height"])
    return window


def load(vtk, folder, window):
    """The renderer that the campus is in, with a sun and a light from everywhere."""
    importer = vtk.vtkGLTFImporter()
    importer.SetFileName(os.path.join(folder, "campus.glb"))
    importer.SetRenderWindow(window)
    importer.Update()
    renderer = importer.GetRenderer()
    renderer.SetBackground(0.45, 0.6, 0.8)
    for actor in renderer.GetActors():
        surface = actor.GetProperty()
        # Plain light on the same pictures, not the dearer one that glTF asks for.
        picture = surface.GetTexture("albedoTex")
        surface.RemoveAllTextures()
        surface.SetInterpolationToGouraud()
        surface.SetAmbient(0.35)
        surface.SetSpecular(0.0)
        if picture is not None:
            picture.MipmapOn()
            picture.InterpolateOn()
            picture.SetMaximumAnisotropicFiltering(1.0)  # as ours: with more a view takes seconds on this driver
            actor.SetTexture(picture)
    return renderer


def add_sun(vtk, renderer, views):
    """Far away, as ours."""
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    sun = vtk.vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPositional(False)
    sun.SetPosition(*(1000.0 * x for x in views["to_sun"]))
    sun.SetFocalPoint(0.0, 0.0, 0.0)
    renderer.AddLight(sun)


def draw(window, renderer, view, pixel):
    """Milliseconds until a pixel of the picture was there: in `pixel`, an array of bytes."""
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*view["eye"])
    camera.SetFocalPoint(*view["target"])
    camera.SetViewUp(0.0, 1.0, 0.0)
    camera.SetClippingRange(0.1, 4000.0)
    start = time.perf_counter()
    window.Render()
    window.GetPixelData(0, 0, 0, 0, 0, pixel, 0)
    return 1000.0 * (time.perf_counter() - start)


def save(vtk, window, file):
    """What the window holds."""
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()


def main(folder):
    """All looks."""
    server = start_display()
    try:
        import vtk  # pylint: disable=import-outside-toplevel  # wants the display
        with open(os.path.join(folder, "views.json"), encoding="utf-8") as file:
            views = json.load(file)
        pixel = vtk.vtkUnsignedCharArray()
        for look, samples, fxaa in LOOKS:
            window = make_window(vtk, views, samples)
            renderer = load(vtk, folder, window)
            renderer.SetUseFXAA(fxaa)
            add_sun(vtk, renderer, views)
            renderer.GetActiveCamera().SetViewAngle(views["fov_deg"])
            for turn in range(views["rounds"] + 1):  # the first is for warming up
                for number, view in enumerate(views["views"]):
                    milliseconds = draw(window, renderer, view, pixel)
                    if turn > 0:
                        print(f"frame {look} {number} {milliseconds:.3f}")
            draw(window, renderer, views["views"][0], pixel)
            save(vtk, window, os.path.join(folder, f"vtk-{look}.png"))
            print(f"# VTK {vtk.vtkVersion.GetVTKVersion()}, {samples} samples", flush=True)
            window.Finalize()
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main(sys.argv[1])
