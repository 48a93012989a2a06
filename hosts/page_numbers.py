"""Holds the numbers on a host's page to its programs and to what its run printed: each is in one of them, rounded as the page has it.

usage: page_numbers.py HOST LOG
       page_numbers.py solvers LOG...       docs/solvers.md, where it tells of hosts, to all that hosts printed

What follows "within" or "found" is a result, which the run printed. An error that a page gives with one digit may be up to ten times what the run
found. Whole numbers below 100, dates, times, and what stands as code are not looked at; nor what no run finds: ELSEWHERE.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NUMBER = r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.]*\d)"
# Versions, costs by hosts/costs.sh and hosts/lammps/scaling.sh, what follows from a formula, and the step of a program.
ELSEWHERE = {
    "abaqus": "2024 12.2", "adams": "2023.1", "bullet": "3.24", "fenicsx": "0.995", "exudyn": "1.13", "mujoco": "5.3 1.11 0.96 1.19 2.41 2.02 3.50", "ode": "1.41",
    "lammps": "0.472 1.63 95 4.3 1.5 0.8 2.5 8.7 2.3 5.6 1.05 1.12", "mujoco_warp": "1e-7", "simbody": "3.7", "solvers": "120",
}  # fmt: skip


def numbers(text):
    return [float(number) for number in re.findall(NUMBER, text, re.I)]


def prose(page):
    """The page without its programs, links and dates."""
    for code in (r"```.*?```", r"^ {4}(?! *\w+  PASS).*$", r"`[^`]*`", r"\]\([^)]*\)", r"\d+ [A-Z][a-z]+ 20\d\d", r"\d+\.\d s$"):
        page = re.sub(code, " ", page, flags=re.S if "```" in code else re.M)
    return page


def known(number, value, percent, found):
    """Whether a number of a page is one of those found, or, of one digit and small, at most ten times one."""
    digits = len(re.sub(r"e.*|\.|^0\.0*", "", number))
    for other in found:
        for scale in (1, 1e-3, 1e3, 1e-6, 1e6, 1e-9, 1e9) if value >= 1e-3 else (1,):
            if value in {float(f"{other * scale / unit:.{digits}g}") for unit in ((0.01, 1) if percent else (1,))}:
                return True
        if digits == 1 and value < (10 if percent else 0.1) and other <= value * (0.01 if percent else 1) <= 10 * other:
            return True
    return False


def main(host, *logs):
    folder = ROOT / "hosts" / host
    page, folders = folder / "README.md", [folder]
    if host == "solvers":
        page, folders = ROOT / "docs" / "solvers.md", sorted((ROOT / "hosts").iterdir())
    programs = [path for path in (*(each for one in folders for each in one.rglob("*")), *folder.parent.glob("*"),
                *(ROOT / "python/src/asperity/hosts").glob("*")) if path.is_file() and path.suffix not in (".md", ".pyc")]  # fmt: skip
    printed = {number for log in logs for number in numbers(Path(log).read_text(encoding="utf-8"))}
    found = printed | {number for path in programs for number in numbers(path.read_text(encoding="utf-8"))}
    text = page.read_text(encoding="utf-8") if page.exists() else ""
    if host == "solvers":
        found, text = printed, text[text.index("## Lagged or current force") : text.index("## Which transition rate?")]
    page = prose(text)
    wrong = []
    for match in re.finditer(f"({NUMBER})( ?%)?", page, re.I):
        value = float(match[1])
        if value.is_integer() and value < 100 and not match[2]:
            continue
        is_result = re.search(r"\b(within|found)\s+$", page[: match.start()])
        if match[1] not in ELSEWHERE.get(host, "").split() and not known(match[1], value, match[2], printed if is_result else found):
            wrong.append(match[0] + " in " + page[max(0, match.start() - 40) : match.end() + 20].replace("\n", " "))
    for number in wrong:
        print(f"the page of {host}: no program has and no run printed {number}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
