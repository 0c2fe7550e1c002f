# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the ParaView plugin says of the classes is so: commands, defaults, ranges, choices.

    TestProxies.py SOURCE_FOLDER BUILD_FOLDER
"""

import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pemesh
from vtkmodules.vtkCommonCore import vtkStringOutputWindow, vtkOutputWindow


class Errors:
    """Counts the errors that filters report while it is in use."""

    def __enter__(self):
        self.window = vtkStringOutputWindow()
        self.before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.window)
        return self

    def text(self):
        return self.window.GetOutput()

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(self.before)


def numbers(text):
    return [float(word) for word in (text or "").split()]


def set_value(instance, element, values):
    option = element.get("initial_string")
    arguments = ([option] if option else []) + values
    getattr(instance, element.get("command"))(*arguments)


def default_values(element):
    text = element.get("default_values")
    if element.tag == "StringVectorProperty":
        parts = text.split(element.get("default_values_delimiter") or "\0")
        kinds = (element.get("element_types") or "2 " * len(parts)).split()
        return [part if kind == "2" else float(part) for part, kind in zip(parts, kinds)]
    values = numbers(text)
    return [int(value) for value in values] if element.tag != "DoubleVectorProperty" else values


def get_value(instance, element):
    """What the class answers, or None if it has no such question."""
    getter = getattr(instance, "Get" + element.get("command").removeprefix("Set"), None)
    option = element.get("initial_string")
    if element.get("command") == "SetShapeByName":
        getter = instance.GetShapeName
    if not element.get("command").startswith("Set") or getter is None:
        return None
    return getter(option) if option else getter()


def check_default(proxy, element, fixed):
    """A new object has the default already; setting it is no error and changes nothing."""
    instance = make(proxy, fixed)
    before = get_value(instance, element)
    values = default_values(element)
    if before in (math.inf, -math.inf):
        before = math.copysign(1e300, before)  # ParaView's XML knows no infinity
    if before is not None:
        assert [before] == values, (proxy.get("name"), element.get("name"), before, values)
    with Errors() as errors:
        if element.get("clean_command"):
            getattr(instance, element.get("clean_command"))()
        set_value(instance, element, values)
        assert not errors.text(), (proxy.get("name"), element.get("name"), errors.text())
    assert get_value(instance, element) == before


def accepts(proxy, element, fixed, value):
    """Whether the value arrives in the object without an error."""
    instance = make(proxy, fixed)
    with Errors() as errors:
        set_value(instance, element, [value])
        return not errors.text() and get_value(instance, element) in (value, None)


def check_range(proxy, element, fixed):
    """The ends of a range may be set, and what lies beyond may not where the class has a range."""
    domain = element.find("IntRangeDomain")
    whole = domain is not None
    domain = element.find("DoubleRangeDomain") if domain is None else domain
    if domain is None or element.get("number_of_elements") != "1":
        return 0
    for end, outwards in (("min", -1), ("max", 1)):
        if domain.get(end) is None or element.get("name") == "Rotation":
            continue
        limit = int(domain.get(end)) if whole else float(domain.get(end))
        open_ended = (proxy.get("class"), element.get("name")) in OPEN_ENDS
        assert open_ended or accepts(proxy, element, fixed, limit), (
            proxy.get("name"), element.get("name"), limit)
        beyond = limit + outwards
        if abs(beyond) < 2**31 - 1 and element.get("command") not in JUDGED_LATER:
            assert not accepts(proxy, element, fixed, beyond), (
                proxy.get("name"), element.get("name"), beyond)
    return 1


# Ends that are not in the range themselves, and commands whose value is judged by the update.
OPEN_ENDS = {("vtkPEMDomainMesher", "MaximumArea"), ("vtkPEMPolygonFamily", "Scale")}
JUDGED_LATER = {"SetMaximumArea", "SetGradation", "SetSizeAtPolygons", "SetScale"}


def check_choices(proxy, element, fixed):
    choices = [entry.get("value") for entry in element.findall("StringListDomain/String")]
    for choice in choices:
        assert accepts(proxy, element, fixed, choice), (proxy.get("name"), choice)
    labels = element.findall("EnumerationDomain/Entry")
    for label in labels:
        value = int(label.get("value"))
        assert accepts(proxy, element, fixed, value), (proxy.get("name"), element.get("name"), value)
    if labels:
        assert not accepts(proxy, element, fixed, len(labels)), (proxy.get("name"), "a name missing")
    return bool(choices or labels)


def make(proxy, fixed):
    instance = getattr(pemesh, proxy.get("class"))()
    for element in fixed:
        set_value(instance, element, default_values(element))
    return instance


def check(proxy):
    counts = [0, 0]
    named = [element for element in proxy if element.get("command")]
    assert proxy.findtext("Documentation", "").strip(), proxy.get("name")
    fixed = [element for element in named
             if element.get("panel_visibility") == "never" and element.get("default_values")]
    assert fixed == named[:len(fixed)] or proxy.find("InputProperty") is not None
    for element in named:
        assert hasattr(getattr(pemesh, proxy.get("class")), element.get("command")), (
            proxy.get("class"), element.get("command"))
        hidden = element.get("panel_visibility") == "never"
        assert hidden or element.findtext("Documentation", "").strip(), element.get("name")
        if element.tag != "InputProperty" and element.get("default_values") is not None:
            if element not in fixed:
                check_default(proxy, element, fixed)
            counts[0] += check_range(proxy, element, fixed)
            counts[1] += check_choices(proxy, element, fixed)
    return counts


def main():
    source, build = map(pathlib.Path, sys.argv[1:3])
    tables = pathlib.Path(sys.argv[3] + ".xml")
    subprocess.run([build / "bin/MakeProxies", tables], check=True)
    proxies = [
        proxy
        for file in (source / "Applications/ParaView/Plugin/Proxies.xml", tables)
        for proxy in ElementTree.parse(file).iter()
        if proxy.tag in ("SourceProxy", "WriterProxy")
    ]
    names = [proxy.get("name") for proxy in proxies]
    assert len(set(names)) == len(names) and len(set(p.get("label") for p in proxies)) == len(names)
    assert all(re.fullmatch("PEMesh[A-Za-z0-9]+", name) for name in names), names
    counts = [check(proxy) for proxy in proxies]
    ranges, choices = (sum(column) for column in zip(*counts))
    print(f"{len(proxies)} proxies, {ranges} ranges, {choices} lists of choices.")
    assert len(proxies) > 40 and ranges > 50 and choices > 8
    for family in ("Comb", "Star", "NSided", "Random"):
        assert f"PEMesh{family}Polygon" in names
    for name in ("PEMeshQualityAgglomeration", "PEMeshVoronoiMesh", "PEMeshReader", "PEMeshWriter"):
        assert name in names


main()
