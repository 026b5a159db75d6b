//! The machine on which times are taken.

use std::fs;

/// The processor as far as it says, how many there are, and how the program was compiled.
pub(super) fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info
        .lines()
        .find_map(|line| line.strip_prefix("model name"))
        .map(|rest| rest.trim_start_matches([' ', '\t', ':']).trim().to_owned());
    let model = model.unwrap_or_else(|| "processor unknown".to_owned());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let fused = if cfg!(target_feature = "fma") { "with fused multiply-add" } else { "no fma" };
    let build = if cfg!(debug_assertions) { "unoptimised build" } else { "release build" };
    let (os, arch) = (std::env::consts::OS, std::env::consts::ARCH);
    let compiler = env!("KANE_RUSTC");
    format!("{model}, {cores} cores, {os} {arch}, {fused}; {compiler}, {build}")
}
