//! A rasterizer in Rust as a plugin: exact geometry, top-left, 128-bit integers.
//!
//!     rustc --edition 2021 -O --crate-type cdylib kit/examples/plugin.rs -o lib.so
//!     build/rasterproof check --plugin ./lib.so
//!
//! Every float of a scene within +-2^20 is a whole number of 2^-40ths here, or is refused: then
//! differences have 62 bits, products 124, and nothing rounds.
use std::os::raw::{c_char, c_void};

// kit/rasterproof_plugin.h, version 2. Structures grow at their end: an older copy goes on working.
#[repr(C)]
pub struct Scene {
    size: u32,
    width: i32,
    height: i32,
    clip_space: i32,
    vertices: *const f64,
    triangles: *const i32,
    vertex_count: usize,
    triangle_count: usize,
    cull: i32,
    scissor: [i32; 4],
    tile: i32,
    threads: i32,
}

#[repr(C)]
pub struct Target {
    size: u32,
    samples: i32,
    stride: usize,
    front: *mut u32,
    back: *mut u32,
}

#[repr(C)]
pub struct Plugin {
    version: u32,
    size: u32,
    name: *const c_char,
    summary: *const c_char,
    profile: *const c_char,
    input: u32,
    coverage: u32,
    takes: u32,
    draw: extern "C" fn(*mut c_void, *const Scene, *const Target) -> i32,
    open: Option<extern "C" fn() -> *mut c_void>,
    reset: Option<extern "C" fn(*mut c_void)>,
    close: Option<extern "C" fn(*mut c_void)>,
    fixed: [u32; 4],
    draw_many: Option<
        extern "C" fn(*mut c_void, *const *const Scene, *const *const Target, usize) -> i32,
    >,
    visible: u32,
    barycentrics_of: u32,
    barycentric_error: f64,
    depth_error: f64,
}
unsafe impl Sync for Plugin {}

const UNITS: f64 = (1u64 << 40) as f64; // a pixel
const LIMIT: f64 = (1u64 << 20) as f64; // pixels

type Point = [i128; 2];

/// In units, exactly; None where the number is finer or farther than that.
fn units(x: f64) -> Option<i128> {
    let scaled = x * UNITS;
    if x.abs() <= LIMIT && scaled == scaled.trunc() {
        Some(scaled as i128)
    } else {
        None
    }
}

fn edge(a: Point, b: Point, p: Point) -> i128 {
    (p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])
}

/// Whether a sample on the edge a -> b of a counter-clockwise triangle is the triangle's.
fn is_top_left(a: Point, b: Point) -> bool {
    a[1] < b[1] || (a[1] == b[1] && b[0] < a[0])
}

fn covers(v: &[Point; 3], p: Point) -> bool {
    (0..3).all(|k| {
        let (a, b) = (v[(k + 1) % 3], v[(k + 2) % 3]);
        let e = edge(a, b, p);
        e > 0 || (e == 0 && is_top_left(a, b))
    })
}

/// The corners of triangle t, or None if one is not finite; Err if one is no whole number of units.
fn corners(scene: &Scene, t: usize) -> Result<Option<[Point; 3]>, ()> {
    let mut v = [[0i128; 2]; 3];
    for (k, corner) in v.iter_mut().enumerate() {
        // The caller's arrays hold as many entries as its counts say.
        let index = unsafe { *scene.triangles.add(3 * t + k) } as usize;
        for (axis, coordinate) in corner.iter_mut().enumerate() {
            let x = unsafe { *scene.vertices.add(4 * index + axis) };
            if !x.is_finite() {
                return Ok(None);
            }
            *coordinate = units(x).ok_or(())?;
        }
    }
    Ok(Some(v))
}

extern "C" fn draw(_state: *mut c_void, scene: *const Scene, target: *const Target) -> i32 {
    let (scene, target) = unsafe { (&*scene, &*target) };
    let mut drawn = Vec::new();
    for t in 0..scene.triangle_count {
        match corners(scene, t) {
            Err(()) => return 1,
            Ok(None) => {}
            Ok(Some(v)) => drawn.push(v),
        }
    }
    for mut v in drawn {
        let area = edge(v[0], v[1], v[2]);
        if area == 0 {
            continue;
        }
        if area < 0 {
            v.swap(1, 2);
        }
        let counts = if area < 0 { target.back } else { target.front };
        for row in 0..scene.height as usize {
            for i in 0..scene.width as usize {
                let half = 1i128 << 39;
                let p = [((i as i128) << 40) + half, ((row as i128) << 40) + half];
                if covers(&v, p) {
                    unsafe { *counts.add(row * target.stride + i) += 1 };
                }
            }
        }
    }
    0
}

static PLUGIN: Plugin = Plugin {
    version: 2,
    size: std::mem::size_of::<Plugin>() as u32,
    name: b"example in Rust\0".as_ptr() as *const c_char,
    summary: b"exact in 128-bit integers, every pixel of the target\0".as_ptr() as *const c_char,
    profile: b"{\"name\": \"within 2^20\", \"coordinate_limit\": \"0x1p+20\"}\0".as_ptr()
        as *const c_char,
    input: 0,    // float32
    coverage: 0, // counts of either facing
    takes: 0,
    draw,
    open: None,
    reset: None,
    close: None,
    fixed: [0; 4],
    draw_many: None,
    visible: 0,
    barycentrics_of: 0,
    barycentric_error: 0.0,
    depth_error: 0.0,
};

#[no_mangle]
pub extern "C" fn rasterproof_plugin_describe() -> *const Plugin {
    &PLUGIN
}
