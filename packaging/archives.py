"""Archives whose bytes depend on nothing but the files in them: sorted names, one date, one owner, one of two modes."""

import gzip
import io
import lzma
import os
import tarfile
import time
import zipfile


def sorted_files(folder):
    """Files and links below a folder, in one order everywhere."""
    return sorted((path for path in folder.rglob("*") if path.is_symlink() or path.is_file()), key=lambda p: p.as_posix())


def mode_of(path):
    """Executable for all, or readable for all."""
    return 0o755 if path.stat().st_mode & 0o100 else 0o644


def pack(folder, archive, epoch, top):
    """Packs a folder under the name `top`, as the archive's ending says."""
    if archive.name.endswith(".zip"):
        pack_zip(folder, archive, epoch, top)
    else:
        pack_tar(folder, archive, epoch, top)


def pack_tar(folder, archive, epoch, top):
    """A tar archive, compressed if its name ends in .xz or .gz; `top` may be empty."""
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.PAX_FORMAT) as tar:
        for path in sorted_files(folder):
            info = tarfile.TarInfo(f"{top}/{path.relative_to(folder).as_posix()}".lstrip("/"))
            info.mtime = epoch
            if path.is_symlink():
                info.type, info.mode, info.linkname = tarfile.SYMTYPE, 0o777, os.readlink(path)
                tar.addfile(info)
            else:
                info.mode, info.size = mode_of(path), path.stat().st_size
                with path.open("rb") as file:
                    tar.addfile(info, file)
    # gzip would write the time of day.
    compress = {".xz": lambda data: lzma.compress(data, preset=9), ".gz": lambda data: gzip.compress(data, mtime=0)}
    archive.write_bytes(compress.get(archive.suffix, bytes)(plain.getvalue()))


def pack_zip(folder, archive, epoch, top):
    """A zip archive; links become the files that they lead to."""
    date = time.gmtime(epoch)[:6]
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for path in sorted_files(folder):
            info = zipfile.ZipInfo(f"{top}/{path.relative_to(folder).as_posix()}", date)
            info.external_attr = mode_of(path) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(info, path.read_bytes())
