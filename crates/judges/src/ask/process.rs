//! A program that runs for a limited time.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How often we look whether it has ended.
const LOOK: Duration = Duration::from_millis(2);

/// What a program said before it ended.
#[derive(Debug)]
pub(super) struct Said {
    /// whether it ended well
    pub(super) success: bool,
    /// standard output
    pub(super) out: String,
    /// standard error
    pub(super) err: String,
}

/// Runs a program in a folder; `None` if it takes longer than the limit, and is ended.
///
/// Its output goes to files in that folder, so that it never waits for a reader.
pub(super) fn run(
    program: &str,
    arguments: &[&str],
    folder: &Path,
    limit: Duration,
) -> io::Result<Option<Said>> {
    let (out, err) = (folder.join("stdout"), folder.join("stderr"));
    let mut child = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(File::create(&out)?)
        .stderr(File::create(&err)?)
        .spawn()?;
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if start.elapsed() > limit {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        sleep(LOOK);
    };
    let read = |path: &PathBuf| Ok::<_, io::Error>(fs::read_to_string(path).unwrap_or_default());
    Ok(Some(Said { success: status.success(), out: read(&out)?, err: read(&err)? }))
}

/// A folder of our own that goes when it is dropped.
#[derive(Debug)]
pub(super) struct Scratch(pub(super) PathBuf);

impl Scratch {
    pub(super) fn new() -> io::Result<Self> {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("kane-judge-{}-{number}", std::process::id());
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path)?;
        Ok(Self(path))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shell(command: &str, limit: Duration) -> Option<Said> {
        let folder = Scratch::new().expect("there is room");
        run("sh", &["-c", command], &folder.0, limit).expect("there is a shell")
    }

    #[test]
    fn what_a_program_says_is_read_and_one_that_goes_on_is_ended() {
        let minute = Duration::from_secs(60);
        let said = shell("echo out; echo err >&2", minute).expect("it ends");
        assert_eq!((said.success, &*said.out, &*said.err), (true, "out\n", "err\n"));
        assert!(!shell("exit 3", minute).expect("it ends").success);
        assert!(shell("exec sleep 20", Duration::from_millis(20)).is_none());
    }

    #[test]
    fn a_folder_of_our_own_goes() {
        let folder = Scratch::new().expect("there is room");
        let (path, other) = (folder.0.clone(), Scratch::new().expect("there is room"));
        assert!(path.is_dir() && path != other.0);
        drop(folder);
        assert!(!path.exists() && other.0.is_dir());
    }
}
