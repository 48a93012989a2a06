//! A surface from a file: the one place where the library asks the system for anything but memory.

use super::boundary::{self, not_null, Failure};
use super::params::asperity_params;
use super::setters::change;
use super::status::asperity_status;
use crate::error::Error;
use std::ffi::{c_char, CStr};
use std::path::Path;

/// Sets parameters from a surface file, as `asperity_params_set_text` does from its text.
///
/// A message begins with the file: "film.toml: line 3: ...". In WebAssembly, where there are no files, the call fails.
///
/// @param path    of the file: as the system has it, on Windows UTF-8; NUL-terminated
/// @return as `asperity_params_set_text`, and `ASPERITY_INVALID_PARAMETER` for what is no file, or cannot be read
#[no_mangle]
pub unsafe extern "C" fn asperity_params_read(params: *mut asperity_params, path: *const c_char) -> asperity_status {
    boundary::status(|| {
        change(params, |params| {
            not_null(path, "path")?;
            let path = CStr::from_ptr(path);
            let text = with_path(path, |path| file::read(path).map_err(|error| Failure::of_file(path, &error)))?;
            with_path(path, |path| params.set_text(&text, |error| Failure::of_file(path, &error)))
        })
    })
}

/// Does something with a path as the system takes it.
fn with_path<T>(path: &CStr, with: impl FnOnce(&Path) -> Result<T, Failure>) -> Result<T, Failure> {
    #[cfg(unix)]
    let path: &std::ffi::OsStr = std::os::unix::ffi::OsStrExt::from_bytes(path.to_bytes());
    #[cfg(not(unix))]
    let path = path.to_str().map_err(|_| Failure::invalid(format_args!("path: must be UTF-8")))?;
    with(Path::new(path))
}

#[cfg(not(target_family = "wasm"))]
mod file {
    use super::{Error, Path};
    use crate::by_name::LONGEST_TEXT;
    use std::fs::{metadata, File, Metadata, OpenOptions};
    use std::io::Read;

    /// The bytes of a file, all that it has, or one more than a text may have. What is no file with a surface is looked at before it is
    /// opened, since to open a device may start it, and once more after, in case it has become another.
    pub fn read(path: &Path) -> Result<Vec<u8>, Error> {
        let refused = |says: &dyn std::fmt::Display| Error::Meaningless(says.to_string().into());
        let has_surface = |found: std::io::Result<Metadata>| -> Result<u64, Error> {
            let found = found.map_err(|error| refused(&error))?;
            match found.len() {
                _ if !found.is_file() => Err(refused(&"must be a file with a surface, whose keys docs/solvers.md has")),
                // Also what the system only shows as a file, as those in /proc, which may never end.
                0 => Err(refused(&"is empty: must be a file with a surface, whose keys docs/solvers.md has")),
                length => Ok(length.min(LONGEST_TEXT as u64 + 1)),
            }
        };
        has_surface(metadata(path))?;
        let file = open(path).map_err(|error| refused(&error))?;
        let length = has_surface(file.metadata())?;
        let mut text = Vec::new();
        file.take((length + 1).min(LONGEST_TEXT as u64 + 1)).read_to_end(&mut text).map_err(|error| refused(&error))?;
        match text.len() as u64 == length {
            true => Ok(text),
            false => Err(refused(&"has another length than the system says: is it being written?")),
        }
    }

    /// Opens a file without waiting: what is no file any more, such as a pipe, would wait for who writes.
    fn open(path: &Path) -> std::io::Result<File> {
        let mut options = OpenOptions::new();
        #[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple", target_os = "freebsd"))]
        std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, NONBLOCK);
        options.read(true).open(path)
    }

    /// O_NONBLOCK of <fcntl.h>.
    #[cfg(any(target_os = "linux", target_os = "android"))]
    const NONBLOCK: i32 = if cfg!(any(target_arch = "mips", target_arch = "mips64")) { 0o200 } else { 0o4000 };
    #[cfg(any(target_vendor = "apple", target_os = "freebsd"))]
    const NONBLOCK: i32 = 4;
}

#[cfg(target_family = "wasm")]
mod file {
    use super::{Error, Path};

    /// There are none.
    pub fn read(_: &Path) -> Result<Vec<u8>, Error> {
        Err(Error::Meaningless("WebAssembly has no files: give the text of the file".into()))
    }
}
