//! The color of what is behind the meshes, pixel by pixel; its twin is `gpu/shade.wgsl`: line by line alike, same
//! names.

use crate::frame::Frame;
use crate::shade::pixel_noise;
use glam::{Vec2, Vec3, Vec4};

/// The backdrop at a place of the picture [pixel]; `ground` is the light on the floor there.
pub(crate) fn background(frame: &Frame, pixel: Vec2, ground: Vec3) -> Vec3 {
    let place = pixel / Vec2::new(frame.ray_right.w, frame.ray_down.w);
    let down = place.y * place.y * (3.0 - 2.0 * place.y);
    let base = if frame.sky_zenith.w > 0.5 {
        landscape(frame, frame.ray(pixel).normalize_or(Vec3::NEG_Z))
    } else {
        let top = frame.background_top.truncate();
        top.lerp(frame.background_bottom.truncate(), down)
    };
    let from_middle = (place - Vec2::new(0.5, 0.52)) * Vec2::new(1.5, 1.25);
    let corner = from_middle.length_squared().min(1.0);
    let glow = 1.0 + frame.background_top.w * (0.45 - corner * (2.0 - corner));
    // Less than one step of an 8-bit picture, so that the gradient shows no bands.
    let color = base * glow * ground;
    let grain = (pixel_noise(pixel) - 0.5) * (2.2 / 255.0);
    (color + color.map(|c| c.max(0.0).sqrt()) * grain).max(Vec3::ZERO)
}

/// Sky, outlines or floor in a direction.
fn landscape(frame: &Frame, ray: Vec3) -> Vec3 {
    let drop = frame.ground.x - frame.eye.y;
    if ray.y > -1.0e-5 || drop >= 0.0 {
        return outlined(frame, ray, sky(frame, ray));
    }
    let way = drop / ray.y;
    let hit = frame.eye.truncate() + ray * way;
    let from_middle = Vec2::new(hit.x, hit.z).length();
    let dim = (from_middle / frame.floor_near.w).min(100.0);
    let near = frame.floor_near.truncate() / (1.0 + dim * dim * dim * dim);
    let beyond = smooth_between(frame.floor_far.w, frame.floor_far.w * 1.12, from_middle);
    let base = near.lerp(frame.floor_far.truncate(), beyond);
    let grazing = 1.0 + ray.y;
    let mirrors = frame.sun_toward.w + (frame.sun_color.w - frame.sun_toward.w) * beyond;
    let upward = Vec3::new(ray.x, -ray.y, ray.z);
    let mirrored = outlined(frame, upward, sky(frame, upward));
    let floor = base.lerp(mirrored, mirrors * grazing * grazing * grazing);
    let far = way / (way + frame.haze.w);
    floor.lerp(frame.haze.truncate(), far * far)
}

/// The sky in a direction that points up or level.
fn sky(frame: &Frame, ray: Vec3) -> Vec3 {
    let up = (ray.y / frame.sky_horizon.w).clamp(0.0, 1.0);
    let plain = (frame.sky_horizon.truncate()).lerp(frame.sky_zenith.truncate(), up * (2.0 - up));
    let near = ray.dot(frame.sun_toward.truncate()).max(0.0);
    let near_4 = near * near * near * near;
    let near_16 = near_4 * near_4 * near_4 * near_4;
    plain + frame.sun_color.truncate() * (0.35 * near_4 + 0.65 * near_16 * near_16)
}

/// Mountains and trees before the sky. Their heights are sums of waves around the horizon: powers of the direction
/// as a complex number, so that they close without a seam.
fn outlined(frame: &Frame, ray: Vec3, sky: Vec3) -> Vec3 {
    let around = Vec2::new(ray.x, ray.z);
    let around = around / around.length().max(1.0e-6);
    let twice = times(around, around);
    let thrice = times(twice, around);
    let fifth = times(thrice, twice);
    let eighth = times(fifth, thrice);
    let thirteenth = times(eighth, fifth);
    let twenty_first = times(thirteenth, eighth);
    let thirty_fourth = times(twenty_first, thirteenth);
    let fifty_fifth = times(thirty_fourth, twenty_first);
    let eighty_ninth = times(fifty_fifth, thirty_fourth);
    let finest = times(times(eighty_ninth, fifty_fifth), eighty_ninth);
    let ridge = 0.55 + 0.22 * thrice.y + 0.18 * fifth.x - 0.22 * eighth.y.abs()
        + 0.12 * (1.0 - 2.0 * thirteenth.x.abs())
        + 0.05 * (1.0 - 2.0 * thirty_fourth.y.abs());
    let crowns = 0.55
        + 0.12 * thirteenth.y
        + 0.12 * thirty_fourth.y.abs()
        + 0.12 * fifty_fifth.x.abs()
        + 0.09 * eighty_ninth.y.abs()
        + 0.06 * finest.x.abs();
    let before = |sky: Vec3, outline: Vec4, share: f32| {
        let top = outline.w * share;
        let seen = if outline.w > 0.0 {
            1.0 - smooth_between(top - 0.0025, top + 0.0025, ray.y)
        } else {
            0.0
        };
        sky.lerp(outline.truncate(), seen)
    };
    before(before(sky, frame.mountains, ridge), frame.trees, crowns)
}

/// Product of two complex numbers.
fn times(a: Vec2, b: Vec2) -> Vec2 {
    Vec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// 0 up to `low`, 1 from `high` on.
fn smooth_between(low: f32, high: f32, value: f32) -> f32 {
    let share = ((value - low) / (high - low)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Where the ray through a place of the picture meets the floor: x, z and 1, or 0 where it does
/// not.
pub(crate) fn floor_hit(frame: &Frame, pixel: Vec2) -> Vec3 {
    let ray = frame.ray(pixel);
    let drop = frame.ground.x - frame.eye.y;
    let meets = frame.background_bottom.w > 0.5 && ray.y < -1.0e-5 && drop < 0.0;
    if !meets {
        return Vec3::ZERO;
    }
    let hit = frame.eye.truncate() + ray * (drop / ray.y);
    Vec3::new(hit.x, hit.z, 1.0)
}
