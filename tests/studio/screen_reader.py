# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Uses the studio as a screen reader does, over AT-SPI: reads all names, presses a button, and types a new value.
   screen_reader.py STUDIO FOLDER"""
import os
import subprocess
import sys
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi  # noqa: E402

SCRIPT = "range 1f 48f\ncreate ball sphere\nball.position\n  1f (0 0 0)\n  48f (4 0 0)\n"


def until(what, value, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = value()
        if found:
            return found
        time.sleep(0.1)
    raise SystemExit(f"FAIL  waited {seconds} s for: {what}")


def everything(below):
    all = [below]
    for i in range(below.get_child_count()):
        child = below.get_child_at_index(i)
        if child:
            all += everything(child)
    return all


def has(node, state):
    return node.get_state_set().contains(state)


def nodes(application, role):
    return [n for n in everything(application) if n.get_role_name() == role]


def named(application, role, name):
    found = [n for n in nodes(application, role) if n.get_name() == name]
    return found[0] if found else None


def shown(application, name):
    node = named(application, "text", name)
    return node if node and has(node, Atspi.StateType.SHOWING) else None


def act(node, action):
    names = [Atspi.Action.get_action_name(node, i) for i in range(Atspi.Action.get_n_actions(node))]
    if not Atspi.Action.do_action(node, names.index(action)):
        raise SystemExit(f"FAIL  '{node.get_name()}' does not take the action {action}")


def text(node):
    return Atspi.Text.get_text(node, 0, -1)


def is_unused(node):
    """The toolkit keeps rows of tabs without a tab, which nobody sees."""
    return node.get_role_name() == "page tab list" and not nodes(node, "page tab")


def nameless(application):
    """Returns what keys reach and a reader cannot name. A box that can be typed into has a named field inside."""
    return [
        f"{n.get_role_name()} in '{n.get_parent().get_name()}'"
        for n in everything(application)
        if has(n, Atspi.StateType.SHOWING)
        and has(n, Atspi.StateType.FOCUSABLE)
        and not n.get_name().strip()
        and n.get_role_name() not in ("combo box", "filler")
        and not is_unused(n)
    ]


def check(application):
    wrong = nameless(application)
    if wrong:
        raise SystemExit("FAIL  without a name: " + "; ".join(wrong))
    now = named(application, "text", "The time of the playhead. Type a frame number, or a time such as 2.5s.")
    before = text(now)
    act(named(application, "push button", "Next frame"), "Press")
    until("the next frame", lambda: text(now) != before)

    cell = until("the ball in the outliner", lambda: named(application, "table cell", "ball"))
    act(cell, "Toggle")
    act(named(application, "page tab", "Properties"), "Press")
    field = until("the radius of the ball", lambda: shown(application, "radius"))
    subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Betwixt", "windowfocus", "--sync"], check=True)
    Atspi.Component.grab_focus(field)
    until("the focus", lambda: has(field, Atspi.StateType.FOCUSED))
    Atspi.EditableText.set_text_contents(field, "2.5")
    subprocess.run(["xdotool", "key", "Return"], check=True)
    until(
        "the line in the script",
        lambda: any("radius=2.5" in text(t) or "radius 2.5" in text(t) for t in nodes(application, "text")),
    )


def main(studio, folder):
    film = os.path.join(folder, "reader.bx")
    with open(film, "w") as file:
        file.write(SCRIPT)
    always = {"QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1", "QT_QPA_PLATFORM": "xcb"}
    program = subprocess.Popen([studio, film, "--discard"], env={**os.environ, **always})
    try:
        desktop = Atspi.get_desktop(0)

        def window():
            for i in range(desktop.get_child_count()):
                child = desktop.get_child_at_index(i)
                if child and child.get_name() == "betwixt-studio" and child.get_child_count():
                    return child

        application = until("the studio on the bus of screen readers", window)
        until("its controls", lambda: len(everything(application)) > 300)
        check(application)
    finally:
        program.terminate()
        program.wait()


main(*sys.argv[1:])
