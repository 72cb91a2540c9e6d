//! What every picture must obey, drawn by the CPU rasterizer and, where there is an adapter,
//! compared with wgpu.

#![expect(clippy::unwrap_used, reason = "functions that only tests call")]

use glam::{Vec2, Vec3};
use lole_geom::trig;
use lole_render::backdrop::{Floor, Panorama, Shore};
use lole_render::{
    BackShade, Backend, Background, Camera, Gradient, Ground, Image, KeyLight, Landscape, LightRig,
    Material, RenderError, Renderer, RoomLight, Scene, Sides, Size, Texture,
};
use shapes::{Shape, matt, sphere};
use std::f32::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

mod shapes;

/// A square that faces `+Z`, around `center`.
fn square(center: Vec3, half: f32) -> Shape {
    let corner = |x: f32, y: f32| center + Vec3::new(x * half, y * half, 0.0);
    Shape {
        positions: vec![
            corner(-1.0, 1.0),
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
        ],
        uvs: vec![Vec2::ZERO, Vec2::Y, Vec2::ONE, Vec2::X],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    }
}

/// A square of floor at `height`, facing up.
fn floor(height: f32, half: f32) -> Shape {
    let mut shape = square(Vec3::ZERO, half);
    for position in &mut shape.positions {
        *position = Vec3::new(position.x, height, -position.y);
    }
    shape
}

fn front_camera(distance: f32) -> Camera {
    Camera {
        eye: Vec3::Z * distance,
        target: Vec3::ZERO,
        vertical_fov: 0.6,
    }
}

/// No lights but an even room of radiance `room`, no ground, a backdrop of black.
fn plain_scene<'a>(camera: Camera, room: f32) -> Scene<'a> {
    Scene {
        lights: LightRig {
            key: KeyLight {
                color: [0.0; 3],
                ..LightRig::default().key
            },
            boxes: Vec::new(),
            zenith: [room; 3],
            horizon: [room; 3],
            nadir: [room; 3],
            exposure: 1.0,
        },
        background: Background::Gradient(Gradient {
            top: [0.0; 3],
            bottom: [0.0; 3],
            glow: 0.0,
        }),
        ground: None,
        ..Scene::studio(camera)
    }
}

fn draw(scene: &Scene<'_>, size: Size) -> Image {
    let mut renderer = Renderer::new(Backend::Cpu, size).unwrap();
    renderer.render(scene).unwrap()
}

const SMALL: Size = Size::new(96, 96);

/// Sum of red, green and blue at a pixel.
fn brightness(image: &Image, x: u32, y: u32) -> u32 {
    let [r, g, b, _] = image.pixel(x, y).unwrap();
    u32::from(r) + u32::from(g) + u32::from(b)
}

/// Byte of a linear value in sRGB.
fn srgb(linear: f32) -> f32 {
    255.0 * (1.055 * trig::powf(linear, 1.0 / 2.4) - 0.055)
}

#[test]
fn a_sphere_is_brighter_toward_the_key() {
    let (ball, material) = (sphere(Vec3::ZERO, 0.5), matt([0.5; 3]));
    let mut scene = Scene::studio(front_camera(3.0));
    scene.meshes.push(ball.with(&material));
    for (toward, lit, dark) in [(1.0, 66, 30), (-1.0, 30, 66)] {
        scene.lights.key.toward = Vec3::new(toward, 0.3, 0.4);
        scene.lights.boxes.clear();
        let image = draw(&scene, SMALL);
        assert!(brightness(&image, lit, 48) > brightness(&image, dark, 48) + 60);
    }
}

/// A gray ball in an even white room shows its own gray, less the 0.01 of the tone curve's toe.
#[test]
fn a_ball_in_an_even_room_shows_its_albedo() {
    let (ball, material) = (sphere(Vec3::ZERO, 0.5), matt([0.5; 3]));
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.meshes.push(ball.with(&material));
    let image = draw(&scene, SMALL);
    let expected = srgb(0.5 - 0.01);
    for (x, y) in [(48, 48), (40, 60), (60, 40), (48, 66)] {
        let red = f32::from(image.pixel(x, y).unwrap()[0]);
        assert!(
            (red - expected).abs() < 8.0,
            "{red} for {expected} at {x}, {y}"
        );
    }
}

/// A card facing the key light shows albedo times light, less the toe.
#[test]
fn a_card_facing_the_key_shows_its_albedo_times_the_light() {
    let (card, material) = (square(Vec3::ZERO, 0.6), matt([0.4; 3]));
    let mut scene = plain_scene(front_camera(3.0), 0.0);
    scene.lights.key = KeyLight {
        toward: Vec3::Z,
        color: [1.5; 3],
        angular_radius: 0.02,
    };
    scene.meshes.push(card.with(&material));
    let red = f32::from(draw(&scene, SMALL).pixel(48, 48).unwrap()[0]);
    assert!((red - srgb(0.6 - 0.01)).abs() < 2.0, "{red}");
}

#[test]
fn what_lies_under_something_is_darker() {
    let (ground, roof, material) = (floor(0.0, 2.0), floor(0.3, 0.3), matt([0.5; 3]));
    let two_sided = Material {
        sides: Sides::Both,
        ..material.clone()
    };
    let camera = Camera {
        eye: Vec3::new(0.0, 0.25, 3.0),
        target: Vec3::ZERO,
        vertical_fov: 0.6,
    };
    let mut scene = Scene::studio(camera);
    scene.lights.key.toward = Vec3::Y;
    scene.ground = None;
    scene.meshes.push(ground.with(&material));
    let open = draw(&scene, SMALL);
    scene.meshes.push(roof.with(&two_sided));
    let covered = draw(&scene, SMALL);
    // The ray through this pixel meets the ground just behind the middle.
    assert!(brightness(&covered, 48, 47) + 100 < brightness(&open, 48, 47));
    assert_eq!(brightness(&covered, 48, 60), brightness(&open, 48, 60));
}

#[test]
fn the_ground_is_darker_in_shadow_and_far_away_unchanged() {
    let (ball, material) = (sphere(Vec3::new(0.0, 0.5, 0.0), 0.3), matt([0.5; 3]));
    let camera = Camera {
        eye: Vec3::new(0.0, 2.0, 6.0),
        target: Vec3::ZERO,
        vertical_fov: 0.6,
    };
    let mut scene = Scene::studio(camera);
    scene.lights.key.toward = Vec3::new(1.0, 1.0, 0.0);
    scene.background = Background::Gradient(Gradient {
        top: [0.68; 3],
        bottom: [0.80; 3],
        glow: 0.0,
    });
    let open = draw(&scene, SMALL);
    scene.meshes.push(ball.with(&material));
    let shaded = draw(&scene, SMALL);
    // The shadow's middle is half a meter to the left of the ball's foot.
    let (x, y) = (48 - 12, 48);
    assert!(brightness(&shaded, x, y) + 40 < brightness(&open, x, y));
    for corner in [(2, 93), (93, 93), (2, 2), (93, 2)] {
        let (here, there) = (
            brightness(&shaded, corner.0, corner.1),
            brightness(&open, corner.0, corner.1),
        );
        assert!(here.abs_diff(there) <= 3);
    }
}

#[test]
fn the_reverse_of_a_cloth_shows_its_own_color() {
    let material = Material {
        base_color: [0.6, 0.05, 0.05],
        back: Some(BackShade {
            color: [0.05, 0.05, 0.6],
            fade: 1.0,
        }),
        sides: Sides::Both,
        ..matt([0.0; 3])
    };
    let card = square(Vec3::ZERO, 0.6);
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.meshes.push(card.with(&material));
    let [r, _, b, _] = draw(&scene, SMALL).pixel(48, 48).unwrap();
    assert!(r > b + 80, "face: {r} {b}");
    scene.camera = front_camera(-3.0);
    let [r, _, b, _] = draw(&scene, SMALL).pixel(48, 48).unwrap();
    assert!(b > r + 80, "back: {r} {b}");
}

#[test]
fn a_body_is_not_seen_from_inside() {
    let (card, material) = (square(Vec3::ZERO, 0.6), matt([0.5; 3]));
    let mut scene = plain_scene(front_camera(-3.0), 1.0);
    scene.meshes.push(card.with(&material));
    assert_eq!(draw(&scene, SMALL).pixel(48, 48), Some([0, 0, 0, 255]));
}

#[test]
fn an_empty_scene_is_its_backdrop() {
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.background = Background::Gradient(Gradient {
        top: [0.5, 0.4, 0.3],
        bottom: [0.5, 0.4, 0.3],
        glow: 0.0,
    });
    scene.ground = Some(Ground::default());
    let image = draw(&scene, Size::new(50, 37));
    assert_eq!(image.pixels.len(), 50 * 37 * 4);
    for pixel in image.pixels.chunks(4) {
        for (byte, linear) in pixel.iter().zip([0.5, 0.4, 0.3]) {
            assert!((f32::from(*byte) - srgb(linear)).abs() < 2.0);
        }
        assert_eq!(pixel[3], 255);
    }
}

#[test]
fn a_picture_without_pixels_is_refused() {
    for size in [Size::new(0, 10), Size::new(10, 0), Size::new(10, 100_000)] {
        for backend in [Backend::Cpu, Backend::Auto, Backend::Gpu] {
            assert!(matches!(
                Renderer::new(backend, size),
                Err(RenderError::ImageSize { .. })
            ));
        }
    }
}

#[test]
fn the_nearer_hides_the_farther_in_any_order() {
    let (red, green) = (matt([0.6, 0.0, 0.0]), matt([0.0, 0.6, 0.0]));
    let (near, far) = (square(Vec3::Z * 0.01, 0.3), square(Vec3::ZERO, 0.5));
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.meshes = vec![near.with(&red), far.with(&green)];
    let first = draw(&scene, SMALL);
    scene.meshes.reverse();
    let second = draw(&scene, SMALL);
    for image in [&first, &second] {
        let [r, g, ..] = image.pixel(48, 48).unwrap();
        assert!(r > 100 && g < 50);
        let [r, g, ..] = image.pixel(48, 24).unwrap();
        assert!(g > 100 && r < 50);
    }
}

#[test]
fn a_texture_repeats() {
    let colors = [
        [200, 0, 0, 255],
        [0, 200, 0, 255],
        [0, 0, 200, 255],
        [90; 4],
    ];
    let pixels = (0..16_usize)
        .flat_map(|index| colors[index * 7 % 4])
        .collect();
    let material = Material {
        texture: Some(Arc::new(Texture::new(4, 4, pixels).unwrap())),
        ..matt([1.0; 3])
    };
    let mut card = square(Vec3::ZERO, 0.8);
    let moved = {
        let mut scene = plain_scene(front_camera(3.0), 1.0);
        scene.meshes.push(card.with(&material));
        draw(&scene, SMALL)
    };
    for uv in &mut card.uvs {
        *uv += Vec2::new(2.0, -4.0);
    }
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.meshes.push(card.with(&material));
    let other = draw(&scene, SMALL);
    let worst = moved
        .pixels
        .iter()
        .zip(&other.pixels)
        .map(|(a, b)| a.abs_diff(*b))
        .max();
    assert!(worst <= Some(2), "{worst:?}");
    assert_ne!(moved.pixel(20, 20), moved.pixel(40, 20));
}

/// A plane cut into many slivers has no holes: every pixel inside is as bright as the next.
#[test]
fn neighbors_leave_no_gap() {
    let mut shape = Shape::default();
    let count = 40_u16;
    for y in 0..=count {
        for x in 0..=count {
            let jitter = trig::sin(f32::from(x) * 12.9 + f32::from(y) * 78.2) * 0.4;
            let at = Vec2::new(f32::from(x) + jitter, f32::from(y) - jitter) / f32::from(count);
            shape.positions.push((at * 4.0 - 2.0).extend(0.0));
        }
    }
    let stride = u32::from(count) + 1;
    for y in 0..stride - 1 {
        for x in 0..stride - 1 {
            let corner = y * stride + x;
            shape.triangles.push([corner, corner + 1, corner + stride]);
            shape
                .triangles
                .push([corner + 1, corner + stride + 1, corner + stride]);
        }
    }
    let material = matt([0.5; 3]);
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.meshes.push(shape.with(&material));
    let image = draw(&scene, Size::new(173, 131));
    let middle = brightness(&image, 80, 60);
    for pixel in image.pixels.chunks(4) {
        let sum: u32 = pixel[..3].iter().map(|&byte| u32::from(byte)).sum();
        assert!(sum.abs_diff(middle) < 20, "{sum} beside {middle}");
    }
}

#[test]
fn a_surface_that_passes_the_camera_is_drawn_up_to_it() {
    let (ground, material) = (floor(-0.1, 50.0), matt([0.5; 3]));
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.meshes.push(ground.with(&material));
    let image = draw(&scene, SMALL);
    assert!(brightness(&image, 48, 95) > 300);
    assert!(brightness(&image, 3, 70) > 300);
    assert_eq!(brightness(&image, 48, 20), 0);
}

#[test]
fn the_same_bits_on_one_and_three_threads() {
    let (ball, ground) = (sphere(Vec3::new(0.1, 0.4, 0.0), 0.4), floor(0.1, 0.6));
    let (skin, cloth) = (
        Material::skin([0.5, 0.3, 0.2]),
        Material::cloth([0.2, 0.1, 0.5]),
    );
    let mut scene = Scene::studio(front_camera(3.0));
    scene.meshes = vec![ball.with(&skin), ground.with(&cloth)];
    let on_threads = |count| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(count)
            .build()
            .unwrap();
        pool.install(|| draw(&scene, Size::new(160, 120)))
    };
    assert_eq!(on_threads(1), on_threads(3));
}

/// What has not moved is lit as before to the bit, what has moved a little nearly so; another mesh is lit anew.
#[test]
fn a_moved_picture_is_lit_as_the_one_before() {
    let material = matt([0.5, 0.4, 0.3]);
    let at = |x: f32| sphere(Vec3::new(x, 0.6, 0.0), 0.5);
    let (ball, moved, plate) = (at(0.0), at(0.004), square(Vec3::new(0.0, 1.4, 0.0), 0.3));
    let scene = |shapes: &[&'static str]| {
        let mut scene = plain_scene(front_camera(3.0), 0.4);
        scene.ground = Some(Ground::default());
        let shapes = shapes.iter().map(|shape| match *shape {
            "ball" => ball.with(&material),
            "moved" => moved.with(&material),
            _ => plate.with(&material),
        });
        scene.meshes = shapes.collect();
        scene
    };
    let size = Size::new(96, 96);
    let mut renderer = Renderer::new(Backend::Cpu, size).unwrap();
    let mut lit = |shapes: &[&'static str], light: RoomLight| {
        renderer.render_lit(&scene(shapes), light).unwrap()
    };
    let anew = lit(&["ball"], RoomLight::Anew);
    assert!(lit(&["ball"], RoomLight::AsBefore) == anew);
    let as_before = lit(&["moved"], RoomLight::AsBefore);
    let by_itself = lit(&["moved"], RoomLight::Anew);
    let apart = as_before.pixels.iter().zip(&by_itself.pixels);
    let apart = apart.map(|(a, b)| a.abs_diff(*b)).max();
    assert!(apart < Some(4), "{apart:?}");
    let both = lit(&["moved", "plate"], RoomLight::AsBefore);
    assert!(both == lit(&["moved", "plate"], RoomLight::Anew));
}

#[test]
fn numbers_that_are_not_finite_are_refused_by_name() {
    let (good, material) = (sphere(Vec3::ZERO, 0.5), matt([0.5; 3]));
    let mut bad = square(Vec3::ZERO, 0.5);
    bad.positions[2].y = f32::NAN;
    let mut scene = Scene::studio(front_camera(3.0));
    scene.meshes = vec![good.with(&material), bad.with(&material)];
    let mut renderer = Renderer::new(Backend::Cpu, SMALL).unwrap();
    let error = renderer.render(&scene).unwrap_err();
    assert!(matches!(
        error,
        RenderError::NotFinite {
            mesh: 1,
            vertex: 2,
            column: "position"
        }
    ));
    assert!(error.to_string().contains("mesh 1"), "{error}");

    bad.positions[2].y = -0.5;
    bad.uvs[3].x = f32::INFINITY;
    let mut scene = Scene::studio(front_camera(3.0));
    scene.meshes = vec![bad.with(&material)];
    assert!(matches!(
        renderer.render(&scene),
        Err(RenderError::NotFinite {
            mesh: 0,
            vertex: 3,
            column: "texture coordinate"
        })
    ));
}

#[test]
fn broken_meshes_and_cameras_are_refused() {
    let material = matt([0.5; 3]);
    let mut renderer = Renderer::new(Backend::Cpu, SMALL).unwrap();
    let mut shape = square(Vec3::ZERO, 0.5);
    shape.triangles[1][0] = 4;
    let mut scene = Scene::studio(front_camera(3.0));
    scene.meshes = vec![shape.with(&material)];
    assert!(matches!(
        renderer.render(&scene),
        Err(RenderError::VertexIndex {
            mesh: 0,
            triangle: 1,
            vertex: 4,
            vertex_count: 4
        })
    ));

    let mut shape = square(Vec3::ZERO, 0.5);
    shape.uvs.pop();
    scene.meshes = vec![shape.with(&material)];
    assert!(matches!(
        renderer.render(&scene),
        Err(RenderError::ColumnLength {
            mesh: 0,
            given: 3,
            expected: 4,
            ..
        })
    ));

    scene.meshes.clear();
    scene.camera.eye = scene.camera.target;
    assert!(matches!(
        renderer.render(&scene),
        Err(RenderError::Camera { .. })
    ));
}

/// Meshes without area, without triangles, with collapsed corners: nothing to see, nothing broken.
#[test]
fn degenerate_meshes_draw_nothing() {
    let material = Material::cloth([0.5; 3]);
    let empty = Shape::default();
    let mut collapsed = square(Vec3::ZERO, 0.0);
    collapsed.triangles.push([1, 1, 1]);
    let mut scene = plain_scene(front_camera(3.0), 1.0);
    scene.meshes = vec![empty.with(&material), collapsed.with(&material)];
    scene.ground = Some(Ground::default());
    let image = draw(&scene, SMALL);
    assert!(image.pixels.chunks(4).all(|pixel| pixel[..3] == [0, 0, 0]));
}

#[test]
#[expect(clippy::print_stderr, reason = "says why the comparison is skipped")]
fn both_backends_draw_nearly_the_same() {
    let size = Size::new(200, 150);
    let mut gpu = match Renderer::new(Backend::Gpu, size) {
        Ok(gpu) => gpu,
        Err(reason) => {
            eprintln!("skipped: {reason}");
            return;
        }
    };
    let pixels = (0..64_usize)
        .flat_map(|index| [[200, 40, 40, 255], [240, 230, 210, 255]][(index / 8 + index) % 2])
        .collect();
    let print = Arc::new(Texture::new(8, 8, pixels).unwrap());
    let (cloth, skin) = (
        Material::printed_cloth(print),
        Material::skin([0.5, 0.3, 0.2]),
    );
    let (ball, sheet) = (sphere(Vec3::new(0.1, 0.5, 0.0), 0.35), floor(0.2, 0.5));
    let mut scene = Scene::studio(Camera {
        eye: Vec3::new(1.0, 1.0, 3.0),
        target: Vec3::new(0.0, 0.3, 0.0),
        vertical_fov: 0.5,
    });
    scene.meshes = vec![ball.with(&skin), sheet.with(&cloth)];
    for background in [scene.background.clone(), Background::Landscape(landscape())] {
        scene.background = background;
        let by_gpu = gpu.render(&scene).unwrap();
        let by_cpu = draw(&scene, size);
        let pairs = by_gpu.pixels.iter().zip(&by_cpu.pixels);
        let differences: Vec<u8> = pairs.map(|(a, b)| a.abs_diff(*b)).collect();
        let count = differences.len() as f64;
        let mean = differences.iter().map(|&d| f64::from(d)).sum::<f64>() / count;
        let off = differences.iter().filter(|&&d| d > 12).count() as f64 / count;
        let adapter = gpu.description();
        assert!(mean < 0.6, "mean difference {mean} on {adapter}");
        assert!(off < 0.01, "{off} of all bytes differ by more than 12");
    }
}

/// Everything that a landscape can have.
fn landscape() -> Landscape {
    Landscape {
        far: Panorama {
            picture: panorama(|at| {
                let below = at.y > 0.8;
                let hill = at.y > 0.6 + 0.1 * trig::sin(at.x * TAU * 3.0);
                match (below, hill) {
                    (true, _) => [20, 60, 20, if at.x < 0.5 { 255 } else { 0 }],
                    (_, true) => [60, 80, 90, 255],
                    _ => [150, 170, 220, 255],
                }
            }),
            mirrored: checks([180, 190, 220], [90, 100, 140]),
            top: 0.4,
            bottom: -0.1,
        },
        near: Floor {
            paint: checks([190, 160, 120], [150, 120, 90]),
            repeat: 1.5,
            mirror: 0.1,
            waves: 0.0,
        },
        beyond: Floor {
            paint: checks([40, 70, 110], [30, 60, 90]),
            repeat: 4.0,
            mirror: 0.6,
            waves: 0.3,
        },
        shore: Shore {
            toward: [0.0, -1.0],
            distance: 6.0,
            foam: 0.4,
            foam_color: [0.8; 3],
        },
        pool: 20.0,
        haze: [0.5, 0.45, 0.4],
        haze_distance: 200.0,
        glow: 0.0,
        turn: 0.3,
    }
}

/// A panorama of some color at each share of its width and height.
fn panorama(color: impl Fn(Vec2) -> [u8; 4]) -> Arc<Texture> {
    let (width, height) = (256_u16, 64_u16);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = places.flat_map(|(x, y)| {
        let at = Vec2::new(f32::from(x) + 0.5, f32::from(y) + 0.5);
        color(at / Vec2::new(f32::from(width), f32::from(height)))
    });
    Arc::new(Texture::new(width.into(), height.into(), pixels.collect()).unwrap())
}

/// A chessboard of eight by eight.
fn checks(light: [u8; 3], dark: [u8; 3]) -> Arc<Texture> {
    let pixels = (0..64_u8).flat_map(|index| {
        let [r, g, b] = if (index / 8 + index) % 2 == 0 {
            light
        } else {
            dark
        };
        [r, g, b, 255]
    });
    Arc::new(Texture::new(8, 8, pixels.collect()).unwrap())
}

/// One color all over.
fn even(color: [u8; 3]) -> Arc<Texture> {
    checks(color, color)
}

/// A level camera has the horizon in the middle of its picture, whatever its height: what is far away above it,
/// floor below, and the floor beyond the shore nearer to the horizon than the near one.
#[test]
fn the_horizon_of_a_landscape_is_level_with_the_eye() {
    let (sky, water, sand) = ([90, 120, 200], [40, 70, 110], [190, 160, 120]);
    let floor = |color| Floor {
        paint: even(color),
        mirror: 0.0,
        ..landscape().near
    };
    let plain = Landscape {
        far: Panorama {
            picture: even(sky),
            mirrored: even(sky),
            top: 0.4,
            bottom: 0.0,
        },
        near: floor(sand),
        beyond: floor(water),
        shore: Shore {
            foam: 0.0,
            ..landscape().shore
        },
        haze_distance: 1.0e6,
        turn: 0.0,
        ..landscape()
    };
    for height in [0.3, 1.5, 4.0] {
        let camera = Camera {
            eye: Vec3::new(0.0, height, 3.0),
            target: Vec3::new(0.0, height, 0.0),
            vertical_fov: 1.2,
        };
        let scene = Scene {
            background: Background::Landscape(plain.clone()),
            ..Scene::studio(camera)
        };
        let image = draw(&scene, SMALL);
        let near = |y: u32, wanted: [u8; 3]| {
            let pixel = image.pixel(SMALL.width / 2, y).unwrap();
            let mut both = pixel.iter().zip(wanted);
            both.all(|(byte, wanted)| byte.abs_diff(wanted) < 10)
        };
        let middle = SMALL.height / 2;
        assert!(near(0, sky), "{height}");
        assert!(near(middle - 1, sky), "{height}");
        assert!(near(middle + 1, water), "{height}");
        let sees_feet = height < 2.0;
        assert!(!sees_feet || near(SMALL.height - 1, sand), "{height}");
    }
}

/// A panorama shows every direction where it has it, closes without a seam, and turns with the landscape.
#[test]
fn a_panorama_is_seen_in_its_directions() {
    // Red grows from one side to the other of what is ahead, green does around the other half.
    let picture = panorama(|at| {
        let share = |from: f32| {
            let near = (1.0 - (at.x - from).abs() * 4.0).clamp(0.0, 1.0);
            (0..=255_u8)
                .find(|byte| f32::from(*byte) >= near * 255.0)
                .unwrap()
        };
        [share(0.5), share(0.25), share(0.75), 255]
    });
    let seen = |azimuth: f32, turn: f32| {
        let (sin, cos) = trig::sin_cos(azimuth);
        let camera = Camera {
            eye: Vec3::Y,
            target: Vec3::Y + Vec3::new(sin, 0.2, -cos),
            vertical_fov: 0.1,
        };
        let scene = Scene {
            background: Background::Landscape(Landscape {
                far: Panorama {
                    picture: Arc::clone(&picture),
                    mirrored: Arc::clone(&picture),
                    top: 1.0,
                    bottom: 0.0,
                },
                turn,
                ..landscape()
            }),
            ..Scene::studio(camera)
        };
        let image = draw(&scene, SMALL);
        image.pixel(SMALL.width / 2, SMALL.height / 2).unwrap()
    };
    let is = |pixel: [u8; 4], wanted: [u8; 3]| {
        let mut both = pixel.iter().zip(wanted);
        both.all(|(byte, wanted)| byte.abs_diff(wanted) < 16)
    };
    // Ahead, at the left, at the right, behind: both ends of the picture meet there, in black.
    assert!(is(seen(0.0, 0.0), [255, 0, 0]));
    assert!(is(seen(-FRAC_PI_2, 0.0), [0, 255, 0]));
    assert!(is(seen(FRAC_PI_2, 0.0), [0, 0, 255]));
    assert!(is(seen(PI, 0.0), [0, 0, 0]));
    // A turn from `+Z` towards `+X` brings what was ahead, at `-Z`, to `-X`.
    assert!(is(seen(-FRAC_PI_2, FRAC_PI_2), [255, 0, 0]));
    for turn in [-0.01, 0.0, 0.01] {
        assert!(is(seen(PI + turn, 0.0), [0, 0, 0]), "{turn}");
    }
}
