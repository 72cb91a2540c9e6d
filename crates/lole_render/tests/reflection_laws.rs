//! What floors mirror of the meshes that stand on them.

#![expect(clippy::unwrap_used, reason = "functions that only tests call")]

use glam::{Vec2, Vec3};
use lole_geom::{Chance, trig};
use lole_render::backdrop::{Floor, Panorama, Shore};
use lole_render::{Backend, Background, Camera, Image, Landscape, Renderer, Scene, Size, Texture};
use shapes::{matt, sphere};
use std::sync::Arc;

mod shapes;

const SIZE: Size = Size::new(240, 180);

/// A gray plain under a gray sky, whose floor mirrors by so much.
fn polished(mirror: f32) -> Background {
    let gray = || Arc::new(Texture::new(1, 1, vec![120, 120, 120, 255]).unwrap());
    let floor = Floor {
        paint: gray(),
        repeat: 1.0,
        mirror,
        waves: 0.0,
    };
    Background::Landscape(Landscape {
        far: Panorama {
            picture: gray(),
            mirrored: gray(),
            top: 0.4,
            bottom: 0.0,
        },
        near: floor.clone(),
        beyond: floor,
        shore: Shore {
            toward: [0.0, -1.0],
            distance: 1.0e3,
            foam: 0.0,
            foam_color: [0.0; 3],
        },
        pool: 1.0e6,
        haze: [0.5; 3],
        haze_distance: 1.0e6,
        glow: 0.0,
        turn: 0.0,
    })
}

/// A red ball on the plain.
fn picture(camera: Camera, (middle, radius): (Vec3, f32), mirror: f32) -> Image {
    let red = matt([0.8, 0.02, 0.02]);
    let ball = sphere(middle, radius);
    let scene = Scene {
        background: polished(mirror),
        meshes: vec![ball.with(&red)],
        ..Scene::studio(camera)
    };
    let mut renderer = Renderer::new(Backend::Cpu, SIZE).unwrap();
    renderer.render(&scene).unwrap()
}

/// Where a ball is seen, and its radius there [pixel].
fn seen(camera: &Camera, (middle, radius): (Vec3, f32)) -> (Vec2, f32) {
    let ahead = (camera.target - camera.eye).normalize_or_zero();
    let right = ahead.cross(Vec3::Y).normalize_or_zero();
    let up = right.cross(ahead);
    let way = middle - camera.eye;
    let half = Vec2::new(SIZE.width as f32, SIZE.height as f32) * 0.5;
    let scale = half.y / (way.dot(ahead) * trig::tan(0.5 * camera.vertical_fov));
    let at = half + Vec2::new(way.dot(right), -way.dot(up)) * scale;
    (at, radius * scale)
}

/// A floor that mirrors shows a ball where the straight way from the eye to the ball's image below the floor meets
/// it, and nowhere else; one that does not shows none.
#[test]
fn a_polished_floor_mirrors_what_stands_on_it() {
    let mut chance = Chance::new(3);
    for _ in 0..12 {
        let mut between = |low: f32, high: f32| chance.between(low, high);
        let camera = Camera {
            eye: Vec3::new(between(-1.0, 1.0), between(0.8, 2.0), between(3.5, 5.0)),
            target: Vec3::new(0.0, 0.1, 0.0),
            vertical_fov: 1.1,
        };
        let middle = Vec3::new(between(-0.6, 0.6), 0.6, between(-0.6, 0.6));
        let radius = between(0.2, 0.35);
        let [with, without] = [0.6, 0.0].map(|mirror| picture(camera, (middle, radius), mirror));
        let below = middle * Vec3::new(1.0, -1.0, 1.0);
        let (image, reach) = seen(&camera, (below, radius));
        let [mut inside, mut outside] = [0; 2];
        for (x, y) in (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| (x, y))) {
            let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            let redness = |image: &Image| {
                let [red, green, ..] = image.pixel(x, y).unwrap();
                i32::from(red) - i32::from(green)
            };
            let redder = redness(&with) - redness(&without);
            let apart = at.distance(image);
            if apart < 0.5 * reach {
                inside += 1;
                assert!(6 < redder, "{at} {redder}");
            } else if reach + 10.0 < apart {
                outside += 1;
                assert!(redder.abs() < 3, "{at} {redder}");
            }
        }
        assert!(20 < inside && 1000 < outside, "{inside} {outside}");
    }
}

/// Who looks from below the floor, or at nothing, sees no image and no error.
#[test]
fn nothing_is_mirrored_from_below_or_of_nothing() {
    let camera = Camera {
        eye: Vec3::new(0.0, -0.5, 3.0),
        target: Vec3::new(0.0, 0.3, 0.0),
        vertical_fov: 0.8,
    };
    let ball = (Vec3::new(0.0, 0.6, 0.0), 0.3);
    let [with, without] = [0.6, 0.0].map(|mirror| picture(camera, ball, mirror));
    assert!(with.pixels == without.pixels);
    let scene = Scene {
        background: polished(0.6),
        ..Scene::studio(Camera {
            eye: Vec3::new(0.0, 1.0, 3.0),
            ..camera
        })
    };
    let mut renderer = Renderer::new(Backend::Cpu, Size::new(3, 1)).unwrap();
    assert_eq!(renderer.render(&scene).unwrap().pixels.len(), 12);
}
