//! Work away from Python: other threads of Python run meanwhile, and an interrupt is heard.

use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

/// Bytes of the stack on which texts are read and judged; a thread of Python may have little.
const STACK: usize = 64 << 20;
/// How long an interrupt may wait until it is heard.
const WAKING: Duration = Duration::from_millis(20);

/// Whether anybody still waits for the answer.
#[derive(Clone, Debug)]
pub(crate) struct Awaited(Arc<AtomicBool>);

impl Awaited {
    /// Whether to go on.
    pub(crate) fn still(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Does the work in a thread of its own, without the interpreter's lock, and waits for it.
///
/// # Errors
/// What Python's handler of a signal raises, `KeyboardInterrupt` by default: then nobody waits any
/// more, and the work ends as soon as it asks. `OSError` if the system gives no thread.
pub(crate) fn away<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&Awaited) -> T + Send + 'static,
) -> PyResult<T> {
    let awaited = Awaited(Arc::new(AtomicBool::new(true)));
    let (done, mut answer) = channel();
    let asked = awaited.clone();
    let worker = thread::Builder::new().name("kane".to_owned()).stack_size(STACK);
    // nobody may be there any more to take the answer
    let worker = worker.spawn(move || drop(done.send(work(&asked))))?;
    loop {
        let answer = &mut answer;
        match py.detach(move || answer.recv_timeout(WAKING)) {
            Ok(found) => return Ok(found),
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals().inspect_err(|_| awaited.0.store(false, Ordering::Relaxed))?;
            }
            Err(RecvTimeoutError::Disconnected) => {
                if let Err(panic) = worker.join() {
                    resume_unwind(panic);
                }
                return Err(crate::bad_input("the work ended without an answer"));
            }
        }
    }
}
