# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of the library in the user's language: those that painting, values and levels lead to. The others, about
broken meshes, solvers and files, stay English."""

import re
from functools import cache

from .language import say

TEMPLATES = (
    "vertex {vertex} is in '{one}' with value {first} and in '{other}' with value {second}{more}; an overlap rule "
    "decides: first, highest, average",
    "nothing is painted: at least one patch is needed",
    "nothing is painted: {reason}",
    "{what}: left out",
    "patch '{name}' has no vertices",
    "patches {names} and {count} more have no vertices",
    "patches {names} have no vertices",
    "1 vertex lies on a piece without paint, where the field has no value; the first is vertex {vertex}",
    "{count} vertices lie on pieces without paint, where the field has no value; the first is vertex {vertex}",
    "every painted value is {value}, so the field is constant",
    "the window from {low} to {high} is empty",
    "the window from {low} to {high} holds none of the field's range {least} to {greatest}",
    "the surface has no area from {low} to {high} of the field, which levels could share out",
    "the number of levels is {count}, but has to be from {least} to {most}",
    "the step is {step}, but has to be positive",
    "a step of {step} makes more than {most} levels from {low} to {high}",
    "level {place} is {value}, which is not finite{more}",
    "level {level} (at place {place}) lies outside the field's range {low} to {high}{more}",
    "level {level} (at place {place}) has no line, as the field does not cross it{more}",
    "1 of {count} levels repeats another and counts once",
    "{repeated} of {count} levels repeat another and count once",
    "the field is {value} at vertex {vertex}, next to the point",
    "(and 1 more vertex)",
    "(and {count} more vertices)",
    "(and 1 more level)",
    "(and {count} more levels)",
)
_QUOTED = ("what", "reason", "more")  # sentences in sentences
_MORE = r"(?: (?P<more>\(and \d+ more \w+\)))?"  # behind what is said of the first of several


def told(sentence: object) -> str:
    """What the library said, whole or as a part of another of its sentences."""
    text = str(sentence)
    for template, pattern in _patterns():
        if found := pattern.fullmatch(text):
            values = {
                name: told(value) if name in _QUOTED and value else value or ""
                for name, value in found.groupdict().items()
            }
            if values.get("more"):
                values["more"] = " " + values["more"]
            return say(template, **values)
    return text


@cache
def _patterns() -> tuple[tuple[str, re.Pattern[str]], ...]:
    """Every template, and what it looks like with values in the places of their names."""
    return tuple((one, re.compile("".join(map(_pattern, re.split(r"(\{\w+\})", one))))) for one in TEMPLATES)


def _pattern(part: str) -> str:
    """part: words, or a name in braces"""
    if part == "{more}":
        return _MORE
    return f"(?P<{part[1:-1]}>.+?)" if part.startswith("{") else re.escape(part)
