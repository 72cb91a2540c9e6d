//! The shading formula, its twin is `gpu/shade.wgsl`: line by line alike, same names.
//!
//! Diffuse light that wraps a little around the terminator, light through thin cloth, GGX
//! highlights (Walter et al. 2007), grazing sheen, soft shadows whose width grows with the
//! distance of what throws them (Fernando 2005), and the neutral tone curve that Khronos
//! published for product pictures (2024), which keeps the hues of a print.

use crate::Material;
use crate::depth_map::{COARSER_LEVELS, DepthMap};
use crate::frame::Frame;
use crate::whole;
use glam::{Vec2, Vec3, Vec4};
use lole_geom::trig;
use std::f32::consts::PI;
use wide::f32x4;

/// Averages run over eight by eight nodes of a lattice: this many strides to each side.
const RINGS: f32 = 4.0;
/// A penumbra reaches at most this many strides: shifted nodes still cover it.
const SHADOW_RINGS: f32 = 3.6;
/// The search near by is this many levels finer than the one far out.
const NEAR_SEARCH: usize = 2;
/// The finest level that is searched.
const FINEST_SEARCH: usize = 2;
/// Shadows are never sharper than this [texel].
const LEAST_RADIUS: f32 = 2.0;
/// How high things must rise at the rim of a penumbra to count, as a share of the distance of what
/// throws it.
const RISE: f32 = 0.8;
/// A bell over a disk is as wide as an even disk this many times smaller.
pub(crate) const BELL: f32 = 1.22;
/// Shadows from farther away than this [m] do not get softer.
pub(crate) const SOFTEST_DISTANCE: f32 = 0.45;
/// A point is lifted off its own surface by this many texels of the key map.
const LIFT_TEXELS: f32 = 2.0;
/// What is this close in front does not count as in the way [m].
const SLACK: f32 = 0.0015;
/// Per unit of wrap, light crosses this much of the body at the terminator [m].
const WRAP_DEPTH: f32 = 0.06;
/// Cosine to the key light below which a surface counts as no steeper.
const STEEPEST: f32 = 0.1;
/// Cosine to the key light from which on no light crosses the body.
const WRAP_END: f32 = 0.4;
/// Four nodes of a lattice.
const LANES: f32x4 = f32x4::new([0.0, 1.0, 2.0, 3.0]);
/// Light that the tone curve takes off.
const TOE: f32 = 0.01;

/// Constants of one material, laid out for a shader's uniform block.
#[repr(C)]
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct Surface {
    /// Base color; `w` is the roughness.
    pub(crate) base_color: Vec4,
    /// Color of the reverse; `w` is how far the face's color goes there.
    pub(crate) back: Vec4,
    /// Subsurface tint; `w` is the wrap.
    pub(crate) subsurface: Vec4,
    /// Specular, sheen, translucency; `w` is 1 where there is a texture.
    pub(crate) gloss: Vec4,
}

impl Surface {
    pub(crate) fn of(material: &Material) -> Self {
        let (back_color, fade) = material
            .back
            .map_or(([0.0; 3], 0.0), |back| (back.color, back.fade));
        Self {
            base_color: Vec3::from(material.base_color).extend(material.roughness.clamp(0.05, 1.0)),
            back: Vec3::from(back_color).extend(fade.clamp(0.0, 1.0)),
            subsurface: Vec3::from(material.subsurface).extend(material.wrap.clamp(0.0, 1.0)),
            gloss: Vec4::new(
                material.specular,
                material.sheen,
                material.translucency,
                f32::from(u8::from(material.texture.is_some())),
            ),
        }
    }
}

/// One visible point of a surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Point {
    /// Where it is [m].
    pub(crate) position: Vec3,
    /// Unit normal on the side that is seen.
    pub(crate) normal: Vec3,
    /// Share of light given back on the side that is seen.
    pub(crate) albedo: Vec3,
    /// Light of the room on the side that is seen and on the other.
    pub(crate) ambient: [Vec3; 2],
}

/// Color of a surface on the side that is seen.
pub(crate) fn albedo(surface: &Surface, paint: Vec3, is_face: f32) -> Vec3 {
    let face = surface.base_color.truncate() * paint;
    face.lerp(surface.back.truncate(), surface.back.w * (1.0 - is_face))
}

/// Color that the picture shows at a point, linear, 0 to 1.
pub(crate) fn shade(
    frame: &Frame,
    shadow: KeyShadow<'_>,
    surface: &Surface,
    point: &Point,
) -> Vec3 {
    let toward_eye = (frame.eye.truncate() - point.position).normalize_or_zero();
    let toward_key = frame.key_toward.truncate();
    let normal = face_eye(point.normal, toward_eye);
    let key_cosine = normal.dot(toward_key);
    // Thin cloth seen from the dark side is lit from the other.
    let lit_side = if key_cosine < 0.0 && surface.gloss.z > 0.0 {
        -normal
    } else {
        normal
    };
    let wrap = surface.subsurface.w;
    let at_terminator = (1.0 - key_cosine.abs() / WRAP_END).max(0.0);
    let crossed = wrap * WRAP_DEPTH * at_terminator;
    let lift = lit_side * (LIFT_TEXELS * frame.key_color.w) + toward_key * crossed;
    // Nothing of the key light shows past the end of the wrap, unless through cloth.
    let shows = key_cosine > -(wrap + 0.5 * frame.key_toward.w) || surface.gloss.z > 0.0;
    let seen = if shows {
        shadow.seen(point.position + lift, shadow.slope(lit_side))
    } else {
        0.0
    };
    let key = frame.key_color.truncate() * seen;

    // The area of the lamp itself softens the terminator by its angular radius.
    let soft = wrap + 0.5 * frame.key_toward.w;
    let lambert = key_cosine.max(0.0);
    let wrapped = ((key_cosine + soft) / (1.0 + soft)).max(0.0);
    let wrapped = wrapped * wrapped.sqrt();
    let tint = Vec3::ONE.lerp(surface.subsurface.truncate(), 0.85);
    let carried = (wrapped - lambert).max(0.0);
    let direct = key * (tint * carried + lambert.min(wrapped));
    let through = surface.gloss.z * (key * (-key_cosine).max(0.0) + point.ambient[1]);
    // Light that went through the cloth took on its color twice.
    let diffuse = point.albedo * (direct + point.ambient[0])
        + point.albedo * point.albedo.map(f32::sqrt) * through;

    let grazing = 1.0 - normal.dot(toward_eye).clamp(0.0, 1.0);
    let grazing_2 = grazing * grazing;
    let grazing_5 = grazing_2 * grazing_2 * grazing;
    let sheen_tint = Vec3::splat(0.25).lerp(point.albedo, 0.75);
    let sheen = sheen_tint * (point.ambient[0] + direct) * (surface.gloss.y * grazing_2 * grazing);

    let roughness = surface.base_color.w;
    let mirror = surface.gloss.x;
    let smooth = 1.0 - roughness;
    let room_mirror = mirror + (1.0 - mirror) * smooth * smooth * grazing_5 * step(mirror);
    let highlight =
        key * ggx(
            normal,
            toward_eye,
            toward_key,
            roughness + 0.5 * frame.key_toward.w,
        ) * mirror
            * lambert;
    tone_map((diffuse + sheen + highlight + point.ambient[0] * room_mirror) * frame.eye.w)
}

/// Nothing mirrors where the share mirrored head-on is zero.
fn step(mirror: f32) -> f32 {
    (mirror * 50.0).min(1.0)
}

/// A normal of a smoothed surface may point away from the eye at a rim: it is turned to grazing.
fn face_eye(normal: Vec3, toward_eye: Vec3) -> Vec3 {
    let cosine = normal.dot(toward_eye);
    if cosine >= 0.0 {
        normal
    } else {
        (normal - toward_eye * cosine).normalize_or(toward_eye)
    }
}

/// Distribution times visibility of GGX microfacets over the Fresnel term, divided by nothing
/// that can be zero.
fn ggx(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, roughness: f32) -> f32 {
    let half = (toward_eye + toward_light).normalize_or(normal);
    let half_cosine = normal.dot(half).max(0.0);
    let eye_cosine = normal.dot(toward_eye).max(1.0e-3);
    let light_cosine = normal.dot(toward_light).max(1.0e-3);
    let alpha = (roughness * roughness).max(0.01);
    let alpha_2 = alpha * alpha;
    let spread = half_cosine * half_cosine * (alpha_2 - 1.0) + 1.0;
    let distribution = alpha_2 / (PI * spread * spread);
    let k = alpha * 0.5;
    let eye_part = eye_cosine * (1.0 - k) + k;
    let light_part = light_cosine * (1.0 - k) + k;
    // The light is given as what a facing white card shows, that is radiance over π.
    (distribution * PI / (4.0 * eye_part * light_part)).min(12.0)
}

/// `N` points on the unit disk, evenly spread (Vogel 1979).
pub(crate) fn disk<const N: usize>() -> [Vec2; N] {
    const GOLDEN_ANGLE: f32 = 2.399_963_2;
    std::array::from_fn(|index| {
        let radius = ((index as f32 + 0.5) / N as f32).sqrt();
        let (sin, cos) = trig::sin_cos(index as f32 * GOLDEN_ANGLE);
        Vec2::new(cos, sin) * radius
    })
}

/// The key light's map, and how its lamp softens shadows.
///
/// Averages run over texels of a lattice that is fixed to the map, weighted by a bell around the
/// point: they change smoothly from point to point, without the grain of scattered samples.
#[derive(Clone, Copy)]
pub(crate) struct KeyShadow<'a> {
    /// What the light sees.
    pub(crate) map: &'a DepthMap,
    /// Where nothing can be in the way, by texel: depths above are in full light.
    pub(crate) clear_above: &'a [f32],
    /// Tangent of the lamp's angular radius.
    pub(crate) tangent: f32,
    /// Shadows from farther away than this [m] do not get softer.
    pub(crate) softest: f32,
}

impl KeyShadow<'_> {
    /// How much nearer to the light a surface with this unit normal lies from texel to texel [m], along columns and
    /// rows; none where it faces away.
    pub(crate) fn slope(self, normal: Vec3) -> Vec2 {
        let cosine = normal.dot(self.map.axis);
        let per_cosine = cosine.clamp(0.0, STEEPEST) / (STEEPEST * cosine.max(STEEPEST));
        let along = Vec2::new(
            normal.dot(self.map.texel_u.truncate()),
            normal.dot(self.map.texel_v.truncate()),
        );
        along * (-self.map.texel * self.map.texel * per_cosine)
    }

    /// Share of the key light seen from a point of a surface with a `slope`. The surface is not in its own way: where
    /// it rises around the point, only what lies before its plane is.
    pub(crate) fn seen(self, position: Vec3, slope: Vec2) -> f32 {
        let at = self.map.project(position) + Vec3::new(0.0, 0.0, SLACK);
        if self.is_clear(at) {
            return 1.0;
        }
        let per_depth = self.tangent / self.map.texel;
        let search = self.softest * per_depth * BELL;
        let mut level = FINEST_SEARCH;
        while level < COARSER_LEVELS && search > RINGS * (1 << level) as f32 {
            level += 1;
        }
        let far = self.blockers(at, slope, level);
        let close = self.blockers(at, slope, (level - NEAR_SEARCH).max(FINEST_SEARCH));
        // Where nothing is in the way, the nearest texels decide.
        let mean = (far.y + close.y) / (far.x + close.x + 1.0e-4);
        let distance = mean.min(self.softest).max(LEAST_RADIUS / per_depth);
        self.share(at, slope, distance)
    }

    /// Whether nothing is in the way. Outside the map, its rim answers: what rises out of the cone
    /// there rises out of a nearer one.
    fn is_clear(self, at: Vec3) -> bool {
        let column = whole::index(at.x).min(self.map.width - 1);
        let row = whole::index(at.y).min(self.map.height - 1);
        at.z >= self.clear_above[row * self.map.width + column]
    }

    /// Weight of what is in the way, and weight times its distance [m], in eight by eight squares
    /// of a level of the map around a point.
    fn blockers(self, at: Vec3, slope: Vec2, level: usize) -> Vec2 {
        let per_depth = BELL * self.tangent / self.map.texel;
        let step = (1 << level) as f32;
        let lattice = Lattice::around(at / step);
        let at_step = at / step;
        let (mut weights, mut distances) = (f32x4::ZERO, f32x4::ZERO);
        let slope = slope * step;
        // A square holds what is nearest to the light in any of its corners.
        let corner = 0.5 * (slope.x.abs() + slope.y.abs());
        let planes = lattice.columns.map(|right| right * slope.x + corner);
        for node in 0..8 {
            let (row, down) = lattice.row(at_step, node);
            let surfaces = self.map.eight(level, [lattice.column, row]);
            let halves = surfaces.into_iter().zip(planes).zip(lattice.squares);
            for ((surface, plane), square) in halves {
                let plane = (plane + down * slope.y).fast_max(f32x4::ZERO);
                let before = (surface - at.z - plane).fast_max(f32x4::ZERO);
                if !before.simd_gt(f32x4::ZERO).any() {
                    continue;
                }
                // What is in the way counts only where its own penumbra reaches this point, from
                // anywhere in the square; one that falls between squares is left to a finer level.
                let reach = before * (per_depth / step);
                let held = (reach - 0.5).fast_max(f32x4::ZERO).fast_min(f32x4::ONE);
                let reach = (reach + 0.7).fast_min(f32x4::splat(RINGS));
                let per_square = f32x4::ONE / (reach * reach);
                let bell = f32x4::ONE - (square + down * down) * per_square;
                let bell = bell.fast_max(f32x4::ZERO);
                let weight = bell * held * per_square;
                weights += weight;
                distances += weight * before;
            }
        }
        Vec2::new(weights.reduce_add(), distances.reduce_add())
    }

    /// Share of the texels around a point that are not before it, as far out as things at a
    /// `distance` [m] throw their penumbra.
    fn share(self, at: Vec3, slope: Vec2, distance: f32) -> f32 {
        let radius = BELL * distance * self.tangent / self.map.texel;
        // Farther out only what is farther away throws a shadow here; the surface itself, seen
        // aslant, does not.
        let rise = distance * RISE;
        let mut stride = 1;
        while radius > SHADOW_RINGS * stride as f32 {
            stride *= 2;
        }
        let step = stride as f32;
        let first = |at: f32| whole::ceil((at - 0.5) / step - RINGS);
        let (column, row) = (first(at.x), first(at.y));
        // By row and by column, nodes are shifted by quarters of a stride: an edge that runs
        // along the lattice crosses them one by one.
        let down_shifts: [i32; 8] = std::array::from_fn(|node| shift(column, node, stride));
        let below = [0, 4]
            .map(|lane| f32x4::new(std::array::from_fn(|node| down_shifts[lane + node] as f32)));
        let per_square = 1.0 / (radius * radius);
        let (mut hidden, mut all) = (f32x4::ZERO, f32x4::ZERO);
        for node in 0..8_u8 {
            let first = column * stride + shift(row, usize::from(node), stride);
            let row = (row + i32::from(node)) * stride;
            let surfaces = self.map.eight_shifted([first, row], stride, &down_shifts);
            let right = LANES * step + (first as f32 + 0.5 - at.x);
            let down = row as f32 + 0.5 - at.y;
            for (half, surface) in surfaces.into_iter().enumerate() {
                let right = right + half as f32 * 4.0 * step;
                let down = below[half] + down;
                let bell = f32x4::ONE - (right * right + down * down) * per_square;
                let plane = (right * slope.x + down * slope.y).fast_max(f32x4::ZERO);
                let before = surface.simd_gt((f32x4::ONE - bell) * rise + plane + at.z);
                let bell = bell.fast_max(f32x4::ZERO);
                all += bell;
                hidden += before & bell;
            }
        }
        1.0 - hidden.reduce_add() / all.reduce_add()
    }
}

/// Shift [texel] of a row or column of nodes, `node` after the `first`.
fn shift(first: i32, node: usize, stride: i32) -> i32 {
    const QUARTERS: [i32; 4] = [0, 2, 1, 3];
    let quarter = QUARTERS[(first.cast_unsigned() as usize).wrapping_add(node) & 3];
    quarter * stride / 4 - 3 * stride / 8
}

/// Eight by eight texels around a point.
struct Lattice {
    column: i32,
    row: i32,
    /// How far to the right of the point the columns' middles lie, and the squares of that [texel, texel²].
    columns: [f32x4; 2],
    squares: [f32x4; 2],
}

impl Lattice {
    fn around(at: Vec3) -> Self {
        let first = |at: f32| whole::ceil(at - 0.5 - RINGS);
        let (column, row) = (first(at.x), first(at.y));
        let right = LANES + (column as f32 + 0.5 - at.x);
        let columns = [right, right + 4.0];
        Self {
            column,
            row,
            columns,
            squares: columns.map(|right| right * right),
        }
    }

    /// Texel row of a row of nodes, and how far its middle lies from the point.
    fn row(&self, at: Vec3, node: i32) -> (i32, f32) {
        let row = self.row + node;
        (row, row as f32 + 0.5 - at.y)
    }
}

/// A number 0 to 1 for a pixel, spread so that neighbors differ (Jimenez 2014).
pub(crate) fn pixel_noise(pixel: Vec2) -> f32 {
    let fraction = |x: f32| x - whole::floor(x) as f32;
    let (x, y) = (whole::floor(pixel.x) as f32, whole::floor(pixel.y) as f32);
    fraction(52.982_918 * fraction(0.067_110_56 * x + 0.005_837_15 * y))
}

/// Khronos' neutral tone curve: colors below 0.8 stay as they are but for the toe; highlights roll
/// off and lose saturation. The toe is a quarter as deep as published, so that the folds of dark
/// cloth can be read.
pub(crate) fn tone_map(color: Vec3) -> Vec3 {
    const START: f32 = 0.8 - 0.04;
    const DESATURATION: f32 = 0.15;
    let least = color.min_element();
    let offset = if least < 2.0 * TOE {
        least - least * least / (4.0 * TOE)
    } else {
        TOE
    };
    let color = color - offset;
    let peak = color.max_element();
    if peak < START {
        return color;
    }
    let room = 1.0 - START;
    let new_peak = 1.0 - room * room / (peak + room - START);
    let scaled = color * (new_peak / peak);
    let kept = 1.0 / (DESATURATION * (peak - new_peak) + 1.0);
    Vec3::splat(new_peak).lerp(scaled, kept)
}

/// Level of detail of a texture from how fast texel coordinates change from pixel to pixel:
/// between the wider and the narrower direction, never blurred by more than a factor of four.
pub(crate) fn texture_lod(change_x: Vec2, change_y: Vec2) -> f32 {
    let (a, b) = (change_x.length_squared(), change_y.length_squared());
    let (wide, narrow) = (a.max(b), a.min(b));
    let squared = (wide * narrow).sqrt().max(wide * 0.0625).max(1.0e-12);
    0.5 * log2(squared)
}

/// Base-2 logarithm to 1 %, by the exponent bits and a parabola; the same bits everywhere.
pub(crate) fn log2(value: f32) -> f32 {
    let bits = value.to_bits();
    let exponent = (bits >> 23) as f32 - 127.0;
    let mantissa = f32::from_bits((bits & 0x007f_ffff) | 0x3f80_0000) - 1.0;
    exponent + mantissa * (1.346_607 - 0.346_607 * mantissa)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::depth_map::Layers;
    use crate::prepare::Geometry;
    use crate::{Camera, Scene, SceneMesh};

    const SHADER: &str = concat!(include_str!("gpu/shade.wgsl"), include_str!("gpu/key.wgsl"));

    /// The shader of windows.
    const LIVE_SHADER: &str = concat!(
        include_str!("gpu/shade.wgsl"),
        include_str!("gpu/live.wgsl")
    );

    #[test]
    fn the_shaders_are_valid_without_an_adapter() {
        for shader in [SHADER, LIVE_SHADER] {
            let module = naga::front::wgsl::parse_str(shader).unwrap();
            let mut validator = naga::valid::Validator::new(
                naga::valid::ValidationFlags::all(),
                naga::valid::Capabilities::empty(),
            );
            validator.validate(&module).unwrap();
        }
    }

    #[test]
    fn the_shader_has_the_same_constants() {
        for line in [
            format!("const RINGS: f32 = {RINGS:?};"),
            format!("const SHADOW_RINGS: f32 = {SHADOW_RINGS:?};"),
            format!("const NEAR_SEARCH: i32 = {NEAR_SEARCH};"),
            format!("const FINEST_SEARCH: i32 = {FINEST_SEARCH};"),
            format!("const COARSER_LEVELS: i32 = {COARSER_LEVELS};"),
            format!("const LEAST_RADIUS: f32 = {LEAST_RADIUS:?};"),
            format!("const RISE: f32 = {RISE:?};"),
            format!("const BELL: f32 = {BELL:?};"),
            format!("const SOFTEST_DISTANCE: f32 = {SOFTEST_DISTANCE:?};"),
            format!("const LIFT_TEXELS: f32 = {LIFT_TEXELS:?};"),
            format!("const SLACK: f32 = {SLACK:?};"),
            format!("const WRAP_DEPTH: f32 = {WRAP_DEPTH:?};"),
            format!("const STEEPEST: f32 = {STEEPEST:?};"),
            format!("const TOE: f32 = {TOE:?};"),
            format!("const WRAP_END: f32 = {WRAP_END:?};"),
        ] {
            assert!(SHADER.contains(&line), "{line}");
        }
    }

    /// Tangent of the angular radius of the lamp over [`Lit`].
    const TANGENT: f32 = 0.1;

    /// Rectangles under a lamp, by their corners in order.
    struct Lit {
        map: DepthMap,
        clear_above: Vec<f32>,
    }

    impl Lit {
        fn new(rectangles: &[[Vec3; 4]], toward_lamp: Vec3) -> Self {
            let material = Material::default();
            let mut scene = Scene::studio(Camera {
                eye: Vec3::Z,
                target: Vec3::ZERO,
                vertical_fov: 0.5,
            });
            let meshes = rectangles.iter().map(|positions| SceneMesh {
                positions,
                normals: &[],
                uvs: &[],
                colors: &[],
                triangles: &[[0, 1, 2], [0, 2, 3]],
                material: &material,
            });
            scene.meshes = meshes.collect();
            let geometry = Geometry::of(&scene);
            let map = DepthMap::draw(&geometry, toward_lamp, 1536, Layers::Nearest);
            let clear_above = map.clear_above(TANGENT);
            Self { map, clear_above }
        }

        fn shadow(&self) -> KeyShadow<'_> {
            KeyShadow {
                map: &self.map,
                clear_above: &self.clear_above,
                tangent: TANGENT,
                softest: SOFTEST_DISTANCE,
            }
        }
    }

    /// Under a straight edge the light falls off evenly over the width that the lamp's size gives,
    /// half of it where the edge is.
    #[test]
    fn the_penumbra_of_an_edge_is_smooth_and_as_wide_as_the_lamp_says() {
        const HEIGHT: f32 = 0.3;
        let plane = |low: Vec2, high: Vec2, y: f32| {
            [
                [low.x, low.y],
                [low.x, high.y],
                [high.x, high.y],
                [high.x, low.y],
            ]
            .map(|[x, z]| Vec3::new(x, y, z))
        };
        let floor = plane(Vec2::splat(-0.8), Vec2::splat(0.8), 0.0);
        let card = plane(Vec2::new(-0.8, -0.8), Vec2::new(0.0, 0.8), HEIGHT);
        let lit = Lit::new(&[floor, card], Vec3::Y);
        let seen = |x: f32| lit.shadow().seen(Vec3::new(x, 0.0, 0.05), Vec2::ZERO);
        let wide = HEIGHT * TANGENT;
        assert!(seen(-1.3 * wide) < 0.01 && seen(1.3 * wide) > 0.99);
        assert!((seen(0.0) - 0.5).abs() < 0.06, "{}", seen(0.0));
        for step in -40_i16..40 {
            let x = f32::from(step) * 0.001;
            let rise = seen(x + 0.001) - seen(x);
            assert!((-0.004..0.05).contains(&rise), "{rise} at {x}");
        }
    }

    /// On a floor that is lit at a flat angle the shadow of a card is that of the card, as if no floor were in the map.
    #[test]
    fn a_slanted_surface_is_not_in_its_own_way() {
        const HEIGHT: f32 = 0.3;
        let axis = Vec3::new(0.97, 0.25, 0.0).normalize_or_zero();
        let across = Vec3::new(-axis.y, axis.x, 0.0);
        let corners = |middle: Vec3, along: Vec3, z: [f32; 2]| {
            let ends = [(-1.0, z[0]), (-1.0, z[1]), (1.0, z[1]), (1.0, z[0])];
            ends.map(|(side, z)| middle + along * side + Vec3::Z * z)
        };
        let floor = corners(Vec3::ZERO, Vec3::X, [-1.0, 1.0]);
        let card = corners(axis * HEIGHT, across * 0.2, [-1.0, 0.0]);
        let (whole, alone) = (Lit::new(&[floor, card], axis), Lit::new(&[card], axis));
        let slope = whole.shadow().slope(Vec3::Y);
        let (mut off, mut off_before) = (0.0_f32, 0.0_f32);
        for step in -30_i16..30 {
            let at = Vec3::new(0.0, LIFT_TEXELS * whole.map.texel, f32::from(step) * 0.002);
            let wanted = alone.shadow().seen(at, Vec2::ZERO);
            off = off.max((whole.shadow().seen(at, slope) - wanted).abs());
            off_before = off_before.max((whole.shadow().seen(at, Vec2::ZERO) - wanted).abs());
        }
        assert!(off < 0.08, "{off}");
        assert!(0.1 < off_before, "the scene asks for it: {off_before}");
    }

    #[test]
    fn the_tone_curve_keeps_plain_colors_and_never_leaves_the_range() {
        // Below the shoulder only the toe is taken off.
        let plain = tone_map(Vec3::new(0.5, 0.3, 0.2));
        assert!((plain - Vec3::new(0.49, 0.29, 0.19)).abs().max_element() < 1e-6);
        for power in 0..12_i32 {
            let bright = tone_map(Vec3::new(1.0, 0.7, 0.4) * 2.0_f32.powi(power));
            assert!(bright.min_element() >= 0.0 && bright.max_element() <= 1.0);
        }
    }

    #[test]
    fn texture_detail_halves_when_the_picture_shrinks_by_two() {
        let lod = |scale: f32| texture_lod(Vec2::new(scale, 0.0), Vec2::new(0.0, scale));
        assert!(lod(1.0).abs() < 0.02);
        assert!((lod(2.0) - 1.0).abs() < 0.02);
        assert!((lod(3.0) - 1.585).abs() < 0.02);
    }
}
