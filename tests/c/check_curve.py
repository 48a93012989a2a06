"""Checks the example's table and figure: tests/c/check_curve.py TABLE FIGURE."""

import sys
import xml.etree.ElementTree as ElementTree

SVG = "{http://www.w3.org/2000/svg}"


def check_table(path):
    with open(path, encoding="utf-8") as table:
        header, *lines = table.read().splitlines()
    assert header == "# load [N], mu, friction force [N], real area [m^2], contacts", header
    rows = [[float(field) for field in line.split(" ")] for line in lines]
    assert len(rows) == 33, f"{len(rows)} loads"
    assert abs(rows[0][0] / 1e-8 - 1) < 1e-9 and abs(rows[-1][0] - 1) < 1e-9, "not eight decades"
    for line, (load, mu, friction, area, contacts) in zip(lines, rows):
        assert line == " ".join(f"{field:.9e}" for field in (load, mu, friction, area, contacts)), line
        assert abs(mu * load / friction - 1) < 2e-9, f"mu is not F/P at {load}"
        # Shear strength lies between the two constants of Hurtado and Kim; G* is that of polysilicon.
        shear_modulus = 160e9 / (2 * 1.22)
        assert shear_modulus / 1290 <= friction / area <= shear_modulus / 43 * (1 + 1e-9), f"F/A at {load}"
        assert 0 < contacts < 1e5, f"{contacts} contacts at {load}"
    for heavier, lighter in zip(rows[1:], rows):
        assert heavier[1] < lighter[1], "mu does not fall with load"
        assert all(heavier[k] > lighter[k] for k in (0, 2, 3, 4)), "friction, area or contacts fall with load"
    return rows


def check_figure(path, rows):
    root = ElementTree.parse(path).getroot()
    assert root.tag == SVG + "svg", root.tag
    text = " ".join("".join(element.itertext()) for element in root.iter(SVG + "text"))
    for label in ("normal load P [N]", "friction coefficient μ = F/P", "contact physics", "constant μ = "):
        assert label in text, f"the figure does not say '{label}'"
    law = [path for path in root.iter(SVG + "path") if path.get("class") == "law"][0].get("d")
    points = [tuple(float(x) for x in point.split()) for point in law[1:].split(" L")]
    assert len(points) == len(rows), f"{len(points)} points"
    steps = [b[0] - a[0] for a, b in zip(points, points[1:])]
    assert max(steps) - min(steps) < 0.02, "the load axis is not logarithmic"
    # y is linear in mu.
    (_, top), (_, bottom) = points[0], points[-1]
    slope = (bottom - top) / (rows[-1][1] - rows[0][1])
    for (_, y), row in zip(points, rows):
        assert abs(y - top - slope * (row[1] - rows[0][1])) < 0.02, "the curve is not the table"


if __name__ == "__main__":
    check_figure(sys.argv[2], check_table(sys.argv[1]))
    print("the table and the figure are sound")
