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
    use std::fs::{metadata, File};
    use std::io::Read;

    /// The bytes of a file, one more than a text may have at most.
    pub fn read(path: &Path) -> Result<Vec<u8>, Error> {
        let refused = |says: &dyn std::fmt::Display| Error::Meaningless(says.to_string().into());
        // Asked before it is opened: a pipe would wait for who writes.
        if !metadata(path).map_err(|error| refused(&error))?.is_file() {
            return Err(refused(&"must be a file with a surface, whose keys docs/solvers.md has"));
        }
        let file = File::open(path).map_err(|error| refused(&error))?;
        let mut text = Vec::new();
        file.take(LONGEST_TEXT as u64 + 1).read_to_end(&mut text).map_err(|error| refused(&error))?;
        Ok(text)
    }
}

#[cfg(target_family = "wasm")]
mod file {
    use super::{Error, Path};

    /// There are none.
    pub fn read(_: &Path) -> Result<Vec<u8>, Error> {
        Err(Error::Meaningless("WebAssembly has no files: give the text of the file".into()))
    }
}
