# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that compute: each runs one function of blender/pipeline and reports."""

import bpy

from ...blender import expected_memory, preferences
from ...blender.look import material
from ...blender.names import FIELD
from ...language import say
from .. import viewport
from ..common import chosen_meshes, poll_field, poll_mesh, reporting
from ..computing import Computing


class DIRICHLET_OT_solve_field(Computing, bpy.types.Operator):
    bl_idname = "dirichlet.solve_field"
    bl_label = "Solve Field"
    bl_description = (
        "Solve for the smooth field that takes the patches' values, on every selected mesh that has patches, and show "
        "it: attributes dirichlet_field and dirichlet_color, and a material that covers the mesh's own on this object"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        if not _is_painted(context.active_object):
            cls.poll_message_set(say("Add a patch first: paint a vertex group and press + in the list of patches"))
            return False
        return True

    def choose(self, context):
        return [obj for obj in chosen_meshes(context) if _is_painted(obj)]

    def begin(self, objects):
        from ...blender import several

        return several.solve_fields(objects)

    def expected_bytes(self, objects):
        budget = preferences.memory_budget()
        return sum(expected_memory.of_object(obj, budget) for obj in objects)

    def is_slow(self, objects):
        return any(obj.dirichlet.method == "lscg" for obj in objects)

    def finish(self, context, made):
        viewport.show_vertex_colors(context)
        return super().finish(context, made)


class DIRICHLET_OT_make_isolines(Computing, bpy.types.Operator):
    bl_idname = "dirichlet.make_isolines"
    bl_label = "Make Isolines"
    bl_description = (
        "Draw isolines of the field as an object parented to this one, for every selected mesh that has a field. "
        "Running again updates that object; when it is locked or no longer parented, it stays and another is made"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context) and poll_field(cls, context)

    def choose(self, context):
        return [obj for obj in chosen_meshes(context) if FIELD in obj.data.attributes]

    def begin(self, objects):
        from ...blender import several

        return several.make_isolines(objects)

    def expected_bytes(self, objects):
        return sum(expected_memory.of_lines(len(obj.data.vertices)) for obj in objects)


class DIRICHLET_OT_update_colors(bpy.types.Operator):
    bl_idname = "dirichlet.update_colors"
    bl_label = "Update Colors"
    bl_description = "Write the color attribute dirichlet_color anew, through the ramp as it is now"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context) and poll_field(cls, context)

    def execute(self, context):
        from ...blender import pipeline

        with reporting(self):
            pipeline.update_colors(context.active_object)
            return {"FINISHED"}
        return {"CANCELLED"}


class DIRICHLET_OT_restore_materials(bpy.types.Operator):
    bl_idname = "dirichlet.restore_materials"
    bl_label = "Restore Materials"
    bl_description = "Show the mesh's own materials again; the next Solve Field covers them again"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        if not material.hides_others(context.active_object):
            cls.poll_message_set(say("The field's material covers no other"))
            return False
        return True

    def execute(self, context):
        material.restore(context.active_object)
        return {"FINISHED"}


def _is_painted(obj: bpy.types.Object) -> bool:
    return any(patch.enabled for patch in obj.dirichlet.patches)


CLASSES = (
    DIRICHLET_OT_solve_field,
    DIRICHLET_OT_make_isolines,
    DIRICHLET_OT_update_colors,
    DIRICHLET_OT_restore_materials,
)
