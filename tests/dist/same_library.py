"""Whether a wheel has the library of the archive for the same target, which was proved: same_library.py WHEEL PREFIXES."""

import sys
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "packaging"))
from targets import read_targets

wheel, prefixes = Path(sys.argv[1]), Path(sys.argv[2])
(target,) = (target for target in read_targets().values() if target.wheel and wheel.stem.endswith(target.wheel))
shared = prefixes / target.rust / target.shared
name = f"asperity/{shared.name}"
if zipfile.ZipFile(wheel).read(name) != shared.read_bytes():
    sys.exit(f"{wheel.name}: {name} is not {shared}")
