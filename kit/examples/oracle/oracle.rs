// The oracle from Rust, without a package:
//
//     rustc oracle.rs -L LIBRARY_FOLDER -l rasterproof_oracle && ./oracle
//
// Says what legal Vulkan rasterizers do with the samples of one triangle.
use std::ffi::{c_char, c_void, CStr, CString};

extern "C" {
    fn rasterproof_oracle_message() -> *const c_char;
    fn rasterproof_oracle_open(text: *const c_char, opened: *mut *mut c_void) -> i32;
    fn rasterproof_oracle_close(profile: *mut c_void);
    #[allow(clippy::too_many_arguments)]
    fn rasterproof_oracle_covers(
        profile: *const c_void, width: i32, height: i32, x0: f64, y0: f64, x1: f64, y1: f64,
        x2: f64, y2: f64, column: i32, row: i32, s: i32,
    ) -> i32;
}

fn main() {
    let mut vulkan = std::ptr::null_mut();
    let name = CString::new("vulkan").unwrap();
    unsafe {
        if rasterproof_oracle_open(name.as_ptr(), &mut vulkan) != 0 {
            panic!("{}", CStr::from_ptr(rasterproof_oracle_message()).to_string_lossy());
        }
        for row in 0..4 {
            let line: String = (0..4)
                .map(|column| {
                    let decision = rasterproof_oracle_covers(
                        vulkan, 4, 4, 0.0, 0.0, 4.0, 0.0, 0.0, 4.0, column, row, 0,
                    );
                    ['.', '#', '?'][decision as usize]
                })
                .collect();
            println!("{line}");
        }
        rasterproof_oracle_close(vulkan);
    }
}
