//! What the shading formula needs to know about a picture as a whole, laid out for a shader's
//! uniform block (`Frame` in `gpu/shade.wgsl`); the CPU reads the same fields.

use crate::backdrop::Floor;
use crate::bake::{Bake, key_tangent};
use crate::shade::log2;
use crate::{Background, Gradient, Landscape, Scene, Size};
use glam::{Mat4, Vec2, Vec3, Vec4};
use lole_geom::trig;
use std::f32::consts::TAU;

/// Constants of one picture.
#[repr(C)]
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct Frame {
    /// Clip space of the camera.
    pub(crate) clip_from_world: Mat4,
    /// Camera position; `w` is the exposure.
    pub(crate) eye: Vec4,
    /// Ray through the top left corner of the picture; not of unit length. `w` is free: windows
    /// keep the number of shadow taps there.
    pub(crate) ray_corner: Vec4,
    /// Change of the ray from one pixel to the next on the right; `w` is the picture's width.
    pub(crate) ray_right: Vec4,
    /// Change of the ray from one pixel to the next below; `w` is the picture's height.
    pub(crate) ray_down: Vec4,
    /// Unit vector towards the key light; `w` is the tangent of its angular radius.
    pub(crate) key_toward: Vec4,
    /// Color of the key light; `w` is the texel size of its map [m].
    pub(crate) key_color: Vec4,
    /// Texel column of its map from a world point.
    pub(crate) key_texel_u: Vec4,
    /// Texel row of its map from a world point.
    pub(crate) key_texel_v: Vec4,
    /// Backdrop at the top; `w` is the glow.
    pub(crate) background_top: Vec4,
    /// Backdrop at the bottom; `w` is 1 where there is a ground.
    pub(crate) background_bottom: Vec4,
    /// Cosine and sine of the landscape's turn, angle of a pixel [rad], 1 where there is a landscape.
    pub(crate) turned: Vec4,
    /// Sine of the elevation at the upper and the lower edge of the panorama, its level of detail, how far the near
    /// floor is lit [m].
    pub(crate) panorama: Vec4,
    /// Repeats per meter, mirror and waves of the near floor; the distance of haze [m].
    pub(crate) floor_near: Vec4,
    /// Repeats per meter, mirror and waves of the floor beyond; `w` is free.
    pub(crate) floor_beyond: Vec4,
    /// x and z of the direction to the shore, its distance [m]; `w` is free.
    pub(crate) shore: Vec4,
    /// Color of the foam; `w` is its width [m].
    pub(crate) foam: Vec4,
    /// Color of haze; `w` is free.
    pub(crate) haze: Vec4,
    /// Height of the ground [m], x and z of the corner of its light map [m], cells per meter.
    pub(crate) ground: Vec4,
}

/// Where the key light's map and the floor's light lie in the world.
pub(crate) struct Places {
    /// Unit vector towards the key light.
    pub(crate) axis: Vec3,
    /// Size of a texel of its map [m].
    pub(crate) texel: f32,
    /// Texel column of a world point `p`: `dot(texel_u, (p, 1))`.
    pub(crate) texel_u: Vec4,
    /// Texel row of a world point.
    pub(crate) texel_v: Vec4,
    /// The floor's light; `None` where there is no floor.
    pub(crate) ground: Option<GroundPlace>,
}

/// Where the floor's light lies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GroundPlace {
    /// Height of the floor [m].
    pub(crate) height: f32,
    /// x and z of the first cell's corner [m].
    pub(crate) corner: Vec2,
    /// Side of a cell [m].
    pub(crate) cell: f32,
}

impl Frame {
    pub(crate) fn new(scene: &Scene<'_>, size: Size, bake: &Bake) -> Self {
        let map = &bake.key_map;
        let places = Places {
            axis: map.axis,
            texel: map.texel,
            texel_u: map.texel_u,
            texel_v: map.texel_v,
            ground: bake.ground.as_ref().map(|light| GroundPlace {
                height: light.height,
                corner: light.corner,
                cell: light.cell,
            }),
        };
        Self::of(scene, size, &places)
    }

    pub(crate) fn of(scene: &Scene<'_>, size: Size, map: &Places) -> Self {
        let camera = &scene.camera;
        let [right, up, backward] = camera.axes();
        let reach = trig::tan(camera.vertical_fov * 0.5);
        let across = reach * size.aspect();
        let (width, height) = (size.width as f32, size.height as f32);
        let key = &scene.lights.key;
        let (gradient, landscape) = match &scene.background {
            Background::Gradient(gradient) => (*gradient, None),
            Background::Landscape(landscape) => {
                let gradient = Gradient {
                    top: [0.0; 3],
                    bottom: [0.0; 3],
                    glow: landscape.glow,
                };
                (gradient, Some(landscape))
            }
        };
        let of = |get: &dyn Fn(&Landscape) -> Vec4| landscape.map_or(Vec4::ZERO, get);
        let pixel_angle = 2.0 * reach / height;
        let named = |color: [f32; 3], last: f32| Vec3::from(color).extend(last);
        let ground = map.ground.map_or(Vec4::ZERO, |place| {
            Vec4::new(
                place.height,
                place.corner.x,
                place.corner.y,
                1.0 / place.cell,
            )
        });
        Self {
            clip_from_world: camera.clip_from_world(size.aspect()),
            eye: camera.eye.extend(scene.lights.exposure),
            ray_corner: (up * reach - backward - right * across).extend(0.0),
            ray_right: (right * (2.0 * across / width)).extend(width),
            ray_down: (up * (-2.0 * reach / height)).extend(height),
            key_toward: map.axis.extend(key_tangent(&scene.lights)),
            key_color: Vec3::from(key.color).extend(map.texel),
            key_texel_u: map.texel_u,
            key_texel_v: map.texel_v,
            background_top: named(gradient.top, gradient.glow),
            background_bottom: named(gradient.bottom, f32::from(u8::from(map.ground.is_some()))),
            turned: of(&|it| {
                let (sin, cos) = trig::sin_cos(it.turn);
                Vec4::new(cos, sin, pixel_angle, 1.0)
            }),
            panorama: of(&|it| {
                let texel_angle = TAU / it.far.picture.width() as f32;
                let lod = log2((pixel_angle / texel_angle).max(1.0));
                Vec4::new(it.far.top, it.far.bottom, lod, it.pool.max(1.0e-3))
            }),
            floor_near: of(&|it| it.near.constants().extend(it.haze_distance.max(1.0e-3))),
            floor_beyond: of(&|it| it.beyond.constants().extend(0.0)),
            shore: of(&|it| {
                let [x, z] = it.shore.toward;
                Vec4::new(x, z, it.shore.distance, 0.0)
            }),
            foam: of(&|it| Vec3::from(it.shore.foam_color).extend(it.shore.foam.max(0.0))),
            haze: of(&|it| Vec3::from(it.haze).extend(0.0)),
            ground,
        }
    }

    /// Direction of the ray through picture coordinates `at` [pixel], not of unit length.
    pub(crate) fn ray(&self, at: Vec2) -> Vec3 {
        self.ray_corner.truncate()
            + self.ray_right.truncate() * at.x
            + self.ray_down.truncate() * at.y
    }
}

impl Floor {
    /// Repeats per meter, mirror and waves.
    fn constants(&self) -> Vec3 {
        Vec3::new(1.0 / self.repeat.max(1.0e-3), self.mirror, self.waves)
    }
}
