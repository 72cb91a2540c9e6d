//! The color of what is behind the meshes, pixel by pixel; its twin is `gpu/shade.wgsl`: line by line alike, same
//! names.

use crate::cpu::reflection::Reflection;
use crate::frame::Frame;
use crate::shade::{pixel_noise, texture_lod};
use crate::srgb::SrgbTable;
use crate::{Background, Texture, whole};
use glam::{Vec2, Vec3, Vec4};
use lole_geom::trig;
use std::f32::consts::TAU;

/// What a floor mirrors of meshes right before the eye, over what it mirrors of them far away.
const POLISH: f32 = 0.65;

/// What a landscape is painted with.
pub(crate) struct Paints<'a> {
    srgb: &'a SrgbTable,
    far: &'a Texture,
    mirrored: &'a Texture,
    near: &'a Texture,
    beyond: &'a Texture,
    /// What floors mirror of the meshes.
    reflection: Option<&'a Reflection>,
}

impl<'a> Paints<'a> {
    /// Those of a backdrop; `None` where it is no landscape.
    pub(crate) fn of(
        background: &'a Background,
        srgb: &'a SrgbTable,
        reflection: Option<&'a Reflection>,
    ) -> Option<Self> {
        let Background::Landscape(landscape) = background else {
            return None;
        };
        let [far, mirrored, near, beyond] = landscape.paints().map(AsRef::as_ref);
        Some(Self {
            srgb,
            far,
            mirrored,
            near,
            beyond,
            reflection,
        })
    }
}

/// The backdrop at a place of the picture [pixel]; `ground` is the light on the floor there.
pub(crate) fn background(
    frame: &Frame,
    paints: Option<&Paints<'_>>,
    pixel: Vec2,
    ground: Vec3,
) -> Vec3 {
    let noise = pixel_noise(pixel);
    let place = pixel / Vec2::new(frame.ray_right.w, frame.ray_down.w);
    let down = place.y * place.y * (3.0 - 2.0 * place.y);
    let base = if let Some(paints) = paints {
        let ray = frame.ray(pixel).normalize_or(Vec3::NEG_Z);
        landscape(frame, paints, ray, (place, noise))
    } else {
        let top = frame.background_top.truncate();
        top.lerp(frame.background_bottom.truncate(), down)
    };
    let from_middle = (place - Vec2::new(0.5, 0.52)) * Vec2::new(1.5, 1.25);
    let corner = from_middle.length_squared().min(1.0);
    let glow = 1.0 + frame.background_top.w * (0.45 - corner * (2.0 - corner));
    // Less than one step of an 8-bit picture, so that the gradient shows no bands.
    let color = base * glow * ground;
    let grain = (noise - 0.5) * (2.2 / 255.0);
    (color + color.map(|c| c.max(0.0).sqrt()) * grain).max(Vec3::ZERO)
}

/// The panorama or a floor in a direction, which a place of the picture shows.
fn landscape(frame: &Frame, paints: &Paints<'_>, ray: Vec3, (place, noise): (Vec2, f32)) -> Vec3 {
    let drop = frame.ground.x - frame.eye.y;
    let seen = turned(frame, ray);
    if ray.y > -1.0e-5 || drop >= 0.0 {
        let uv = far_uv(frame, paints, seen);
        return paints.far.sample(paints.srgb, uv, frame.panorama.z);
    }
    let mut standing = Vec4::ZERO;
    if ray.y > frame.panorama.y {
        let uv = far_uv(frame, paints, seen);
        standing = (paints.far).sample_with_alpha(paints.srgb, uv, frame.panorama.z);
    }
    let floor = floor(frame, paints, seen, (place, [drop / ray.y, noise]));
    floor.lerp(standing.truncate(), standing.w)
}

/// A place or a direction as the landscape has it, before its turn.
fn turned(frame: &Frame, world: Vec3) -> Vec3 {
    let (cos, sin) = (frame.turned.x, frame.turned.y);
    Vec3::new(
        world.x * cos - world.z * sin,
        world.y,
        world.x * sin + world.z * cos,
    )
}

/// Where the panorama shows a direction.
fn far_uv(frame: &Frame, paints: &Paints<'_>, seen: Vec3) -> Vec2 {
    let around = trig::atan2(seen.x, -seen.z) / TAU + 0.5;
    let margin = 0.5 / paints.far.height() as f32;
    let down = (frame.panorama.x - seen.y) / (frame.panorama.x - frame.panorama.y);
    Vec2::new(around, down.clamp(margin, 1.0 - margin))
}

/// Something like a sine of whole turns, of parabolas.
fn wave(turns: f32) -> f32 {
    let part = turns - whole::floor(turns + 0.5) as f32;
    part * (8.0 - 16.0 * part.abs())
}

/// The floor in a direction, a `way` along it [m]; by `noise` one level of detail turns into the next.
fn floor(
    frame: &Frame,
    paints: &Paints<'_>,
    seen: Vec3,
    (place, [way, noise]): (Vec2, [f32; 2]),
) -> Vec3 {
    let hit = turned(frame, frame.eye.truncate()) + seen * way;
    let at = Vec2::new(hit.x, hit.z);
    let from_middle = at.length();
    let across = way * frame.turned.z;
    let along = across / (-seen.y).max(1.0e-3);
    let toward = Vec2::new(frame.shore.x, frame.shore.y);
    let mut out = at.dot(toward) - frame.shore.z;
    let foam = frame.foam.w;
    if foam > 0.0 {
        let side = at.perp_dot(toward);
        out += foam
            * (0.55 * wave(side * 0.06 + 0.1)
                + 0.30 * wave(side * 0.18)
                + 0.12 * wave(side * 0.5 + 0.3));
    }
    let edge = (0.6 * along).max(0.02);
    let beyond = smooth_between(-edge, edge, out);
    let wet = if foam > 0.0 {
        smooth_between(-5.0 * foam, -0.6 * foam, out)
    } else {
        0.0
    };
    let lod = |paint: &Texture, repeats: f32| {
        let texels = repeats * paint.width() as f32;
        painted_lod(Vec2::new(across, along) * texels, noise)
    };
    let mut base = Vec3::ZERO;
    let mut mirrors = 0.0;
    let mut waves = 0.0;
    if beyond < 1.0 {
        let paint = paints.near.sample(
            paints.srgb,
            at * frame.floor_near.x,
            lod(paints.near, frame.floor_near.x),
        );
        let dim = (from_middle / frame.panorama.w).min(100.0);
        let slow = wave(at.x * 0.13 + 0.27 * wave(at.y * 0.1));
        let tone = 1.0 + 0.05 * slow * wave(at.y * 0.11 + 0.2);
        let lit = tone / (1.0 + dim * dim * dim * dim);
        base = paint * (lit * (1.0 - 0.45 * wet));
        mirrors = frame.floor_near.y + 0.55 * wet;
        waves = frame.floor_near.z * paint.y;
    }
    if beyond > 0.0 {
        let paint = paints.beyond.sample(
            paints.srgb,
            at * frame.floor_beyond.x,
            lod(paints.beyond, frame.floor_beyond.x),
        );
        base = base.lerp(paint, beyond);
        mirrors += (frame.floor_beyond.y - mirrors) * beyond;
        waves += (frame.floor_beyond.z * paint.y - waves) * beyond;
    }
    let grazing = 1.0 + seen.y;
    let share = mirrors * grazing * grazing * grazing;
    if share > 0.002 {
        let upward = far_uv(frame, paints, Vec3::new(seen.x, waves - seen.y, seen.z));
        let mirrored = paints.mirrored.sample(paints.srgb, upward, 0.0);
        base = base.lerp(mirrored, share.min(1.0));
    }
    if mirrors > 0.0 {
        // Who stands on polished boards is seen in them from above, too.
        let polish = mirrors * (POLISH + (1.0 - POLISH) * grazing * grazing * grazing);
        let reflected = (paints.reflection).map_or(Vec4::ZERO, |it| it.sample(place));
        base = base * (1.0 - polish * reflected.w) + reflected.truncate() * polish;
    }
    if foam > 0.0 {
        let swash = smooth_between(-0.5 * foam, -0.1 * foam, out);
        let spent = smooth_between(0.1 * foam, 1.6 * foam, out);
        base = base.lerp(frame.foam.truncate(), swash * (1.0 - spent));
    }
    let far = way / (way + frame.floor_near.w);
    base.lerp(frame.haze.truncate(), far * far)
}

/// Level of detail of a floor's paint; `sides` are those of a pixel there in its texels.
fn painted_lod(sides: Vec2, noise: f32) -> f32 {
    let lod = texture_lod(Vec2::new(sides.x, 0.0), Vec2::new(0.0, sides.y));
    whole::floor(lod + noise).max(0) as f32
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
