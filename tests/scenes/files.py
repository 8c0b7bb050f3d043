"""Drawings and models of files, from the folder `data` beside this file."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import CENTER, CORNER, CORNERS, P3D
from tests.scenes.registry import scene


@scene()
def svg_paths_holes_and_curves(g: PGraphics) -> None:
    g.background(240)
    g.shape(g.loadShape("shapes.svg"), 0, 0)


@scene(P3D)
def svg_in_3d(g: PGraphics) -> None:
    g.background(240)
    g.translate(50, 50)
    g.rotateY(0.6)
    g.shape(g.loadShape("shapes.svg"), -50, -50)


@scene()
def svg_groups_and_opacity(g: PGraphics) -> None:
    g.background(240)
    g.shape(g.loadShape("groups.svg"), 5, 0)


@scene()
def svg_children_alone_keep_the_transforms_of_their_groups(g: PGraphics) -> None:
    g.background(240)
    drawing = g.loadShape("groups.svg")
    g.shape(drawing.getChild("tile"), 10, 40)
    g.shape(drawing.getChild("dot"), 50, 0)
    g.shape(drawing.getChild("egg"), -10, -40)
    g.shape(drawing.getChild("low"), 30, 0, 40, 30)


@scene(size=(120, 120))
def svg_strokes_with_caps_and_joins(g: PGraphics) -> None:
    g.background(240)
    g.shape(g.loadShape("strokes.svg"), 0, 0)


@scene(size=(160, 120))
def svg_strokes_in_another_size(g: PGraphics) -> None:
    g.background(240)
    drawing = g.loadShape("strokes.svg")
    g.shape(drawing, 0, 0, 60, 120)
    g.scale(0.8)
    g.shape(drawing, 90, 5)
    g.shape(drawing.getChild("round"), 60, 70)


@scene()
def svg_in_the_look_of_the_sketch(g: PGraphics) -> None:
    g.background(240)
    drawing = g.loadShape("shapes.svg")
    drawing.disableStyle()
    g.fill(255, 150, 0, 180)
    g.stroke(0, 0, 160)
    g.strokeWeight(2)
    g.shape(drawing, 0, 0)


@scene()
def svg_shape_modes(g: PGraphics) -> None:
    g.background(240)
    drawing = g.loadShape("shapes.svg")
    g.shapeMode(CENTER)
    g.shape(drawing, 22, 22, 40, 30)
    g.shapeMode(CORNERS)
    g.shape(drawing, 50, 5, 95, 45)
    g.shapeMode(CORNER)
    drawing.scale(0.4)
    drawing.rotate(0.1)
    g.shape(drawing, 20, 50)


@scene(P3D, size=(120, 120))
def obj_materials_and_texture(g: PGraphics) -> None:
    g.background(40)
    g.lights()
    g.translate(60, 60)
    g.rotateX(-0.5)
    g.rotateY(0.6)
    g.scale(30)
    g.shape(g.loadShape("gate.obj"))


@scene(P3D, size=(120, 120))
def obj_faces_changed_one_by_one(g: PGraphics) -> None:
    g.background(40)
    model = g.loadShape("gate.obj")
    model.setFill(g.color(0, 160, 160))
    model.getChild(1).setFill(g.color(255, 220, 0))
    model.getChild(4).setVertex(2, 0, -1.6, 1.2)
    model.getChild(5).translate(0, 0.3, 0)
    model.scale(30)
    g.lights()
    g.translate(60, 60)
    g.rotateX(0.4)
    g.rotateY(-0.6)
    g.shape(model)


@scene(P3D, size=(120, 120))
def obj_in_the_look_of_the_sketch(g: PGraphics) -> None:
    g.background(40)
    model = g.loadShape("gate.obj")
    model.disableStyle()
    g.fill(0, 180, 255)
    g.stroke(255, 255, 0)
    g.strokeWeight(2)
    g.tint(255, 200, 100)
    g.translate(60, 60)
    g.rotateX(-0.5)
    g.rotateY(radians(36))
    g.scale(30)
    g.shape(model)


@scene(P3D, size=(120, 120))
def obj_stroke_without_a_weight_is_not_seen(g: PGraphics) -> None:
    g.background(40)
    model = g.loadShape("gate.obj")
    model.setStroke(True)
    model.setStroke(g.color(255))
    g.translate(60, 60)
    g.rotateY(0.5)
    g.scale(30)
    g.shape(model)
