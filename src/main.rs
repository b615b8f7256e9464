//! Chooses the platform, and nothing else.

#[cfg(all(feature = "app", not(target_arch = "wasm32")))]
fn main() -> std::process::ExitCode {
    depth_calculator::platform::desktop::main()
}

#[cfg(all(not(feature = "app"), not(target_arch = "wasm32")))]
fn main() -> std::process::ExitCode {
    depth_calculator::cli::main()
}

#[cfg(target_arch = "wasm32")]
fn main() {
    depth_calculator::platform::web::main();
}
