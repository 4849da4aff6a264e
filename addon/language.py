# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts in the user's language, where Blender does not translate by itself: those with names and numbers in them, and
what polls say. The texts themselves are English and plain literals, so that the table of a language can be checked."""

import bpy

_of_reports = getattr(bpy.app.translations, "pgettext_rpt", bpy.app.translations.pgettext_tip)  # its own from 4.1 on


def say(message: str, **values: object) -> str:
    """A sentence: of a report, an error, a warning or a tooltip. The values take the places named in braces."""
    return _of_reports(message).format(**values)


def counted(count: int, one: str, many: str) -> str:
    """So many of something: `one` says "1 …", `many` has the place {count}."""
    return say(one) if count == 1 else say(many, count=count)


def label(text: str, **values: object) -> str:
    """A text in a panel, with values as `say` takes them."""
    return bpy.app.translations.pgettext_iface(text).format(**values)
