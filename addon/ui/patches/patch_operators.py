# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the list of patches."""

import bpy
from bpy.props import StringProperty

from ...language import say
from ..common import poll_mesh, poll_patch

_ANY_MODE = ("OBJECT", "PAINT_WEIGHT", "PAINT_VERTEX", "EDIT_MESH")


def _unlisted(obj: bpy.types.Object) -> list[str]:
    """Vertex groups without a patch, the active one first."""
    listed = {patch.group for patch in obj.dirichlet.patches}
    groups = [group for group in obj.vertex_groups if group.name not in listed]
    return [group.name for group in sorted(groups, key=lambda group: group != obj.vertex_groups.active)]


class DIRICHLET_OT_patch_add_group(bpy.types.Operator):
    bl_idname = "dirichlet.patch_add_group"
    bl_label = "Add Patch from Group"
    bl_description = (
        "Add a patch for the active vertex group, or for the first one that has no patch yet; else for a new, empty "
        "one, to be painted"
    )
    bl_options = {"REGISTER", "UNDO"}

    group: StringProperty(
        name="Vertex Group",
        description="Vertex group of the patch; empty: the active one, the first without patch, or a new one",
    )

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        from ...blender.paint import patches

        obj = context.active_object
        if self.group and self.group not in obj.vertex_groups:
            self.report(
                {"ERROR"}, say("Object '{object}' has no vertex group '{group}'", object=obj.name, group=self.group)
            )
            return {"CANCELLED"}
        names = [self.group] if self.group else _unlisted(obj)
        if names:
            patches.add(obj, names[0])
            patches.recheck(obj)
        else:
            patches.add_group(obj, "Patch", ())
        return {"FINISHED"}


class DIRICHLET_OT_patch_add_selected(bpy.types.Operator):
    bl_idname = "dirichlet.patch_add_selected"
    bl_label = "Add Patch from Selected"
    bl_description = (
        "Make a vertex group of the vertices last selected in Edit Mode, and a patch for it. Leaves Edit Mode"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context, _ANY_MODE)

    def execute(self, context):
        from ...blender.mesh import meshes
        from ...blender.paint import patches

        obj = context.active_object
        editing = obj.mode == "EDIT"
        if editing:  # the mesh has the selection and takes weights only outside
            bpy.ops.object.mode_set(mode="OBJECT")
        selected = meshes.selected_vertices(obj.data)
        if not selected.size:
            if editing:
                bpy.ops.object.mode_set(mode="EDIT")
            self.report(
                {"ERROR"}, say("No vertex of '{object}' is selected: select some in Edit Mode", object=obj.name)
            )
            return {"CANCELLED"}
        patches.add_group(obj, "Patch", selected)
        patches.recheck(obj)
        return {"FINISHED"}  # still outside: an undo step made in Edit Mode has no list of patches


class DIRICHLET_OT_patch_paint(bpy.types.Operator):
    bl_idname = "dirichlet.patch_paint"
    bl_label = "Paint Patch"
    bl_description = "Go to Weight Paint mode with the vertex group of the selected patch active"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context) and poll_patch(cls, context)

    def execute(self, context):
        obj = context.active_object
        group = obj.vertex_groups.get(obj.dirichlet.patches[obj.dirichlet.active_patch].group)
        if group is None:
            self.report({"ERROR"}, "The patch has no vertex group: pick one in its row of the list first")
            return {"CANCELLED"}
        obj.vertex_groups.active_index = group.index
        bpy.ops.object.mode_set(mode="WEIGHT_PAINT")
        return {"FINISHED"}


class DIRICHLET_OT_patch_spread_values(bpy.types.Operator):
    bl_idname = "dirichlet.patch_spread_values"
    bl_label = "Spread Values"
    bl_description = "Give the enabled patches evenly spaced values from 0 to 1, in the order of the list"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        if not any(patch.enabled for patch in context.active_object.dirichlet.patches):
            cls.poll_message_set(say("Add a patch first"))
            return False
        return True

    def execute(self, context):
        patches = [patch for patch in context.active_object.dirichlet.patches if patch.enabled]
        for place, patch in enumerate(patches):
            patch.value = place / max(len(patches) - 1, 1)
        return {"FINISHED"}


CLASSES = (
    DIRICHLET_OT_patch_add_group,
    DIRICHLET_OT_patch_add_selected,
    DIRICHLET_OT_patch_paint,
    DIRICHLET_OT_patch_spread_values,
)
