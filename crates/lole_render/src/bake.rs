//! Light that is worked out once for a picture and shared by both backends: the key light's
//! shadow map, the light that reaches each vertex from the studio around it, and the floor.

mod ambient;
mod ground;
mod studio;

pub(crate) use ground::{CELLS as GROUND_CELLS, GroundLight};
use studio::{Room, Studio};

use crate::depth_map::{DepthMap, Layers};
use crate::prepare::Geometry;
use crate::shade::KeyShadow;
use crate::{LightRig, Scene};
use glam::Vec3;
use lole_geom::trig;
use rayon::prelude::*;

/// Longer side of the key light's map [texel]: about 1 mm on a standing dancer.
const KEY_MAP_SIDE: usize = 1536;
/// Longer side of the maps of the surroundings [texel]: about 5 mm on a standing dancer, finer
/// than the folds of a gathered band.
const STUDIO_MAP_SIDE: usize = 352;

/// Light worked out for one picture.
pub(crate) struct Bake {
    /// What the key light sees.
    pub(crate) key_map: DepthMap,
    /// Depth by texel of its map above which nothing is in the way of the key light.
    pub(crate) key_clear: Vec<f32>,
    /// Light of the surroundings on the face and on the back of each vertex, as the radiance of a
    /// white surface there.
    pub(crate) ambient: Vec<[Vec3; 2]>,
    /// Light on the floor.
    pub(crate) ground: Option<GroundLight>,
}

impl Bake {
    pub(crate) fn new(scene: &Scene<'_>, geometry: &Geometry) -> Self {
        let key_axis = unit_toward(scene.lights.key.toward);
        let studio = Studio::new(&scene.lights);
        let axes: Vec<_> = std::iter::once((key_axis, KEY_MAP_SIDE, Layers::Nearest))
            .chain(
                studio
                    .axes
                    .iter()
                    .map(|lobe| (lobe.axis, STUDIO_MAP_SIDE, Layers::Both)),
            )
            .collect();
        let mut maps: Vec<DepthMap> = axes
            .par_iter()
            .map(|&(axis, side, layers)| DepthMap::draw(geometry, axis, side, layers))
            .collect();
        let studio_maps = maps.split_off(1);
        let key_map = maps.swap_remove(0);
        let tangent = key_tangent(&scene.lights);
        let key_clear = key_map.clear_above(tangent);
        let room = Room {
            studio,
            maps: studio_maps,
        };
        let shadow = KeyShadow {
            map: &key_map,
            clear_above: &key_clear,
            tangent,
            softest: ground::SOFTEST_DISTANCE,
        };
        let ground = geometry
            .bounds()
            .and_then(|bounds| GroundLight::new(scene, bounds, &room, shadow));
        let ambient = ambient::by_vertex(geometry, &room, ground.as_ref());
        Self {
            key_map,
            key_clear,
            ambient,
            ground,
        }
    }
}

impl Bake {
    /// The light of a scene: worked out anew, or with the light of the room as it was in a picture before.
    pub(crate) fn lit(scene: &Scene<'_>, geometry: &Geometry, before: Option<Self>) -> Self {
        let same = |bake: &Self| bake.ambient.len() == geometry.positions.len();
        let Some(before) = before.filter(same) else {
            return Self::new(scene, geometry);
        };
        let key_axis = unit_toward(scene.lights.key.toward);
        let key_map = DepthMap::draw(geometry, key_axis, KEY_MAP_SIDE, Layers::Nearest);
        let key_clear = key_map.clear_above(key_tangent(&scene.lights));
        Self {
            key_map,
            key_clear,
            ..before
        }
    }
}

/// Light of the surroundings on the face and on the back of each vertex of `geometry`, without the
/// floor's shadow: what [`Bake`] holds, for pictures that cannot wait for all of it.
pub(crate) fn ambient_alone(lights: &LightRig, geometry: &Geometry) -> Vec<[Vec3; 2]> {
    let studio = Studio::new(lights);
    let maps: Vec<DepthMap> = (studio.axes.par_iter())
        .map(|pair| DepthMap::draw(geometry, pair.axis, STUDIO_MAP_SIDE, Layers::Both))
        .collect();
    ambient::by_vertex(geometry, &Room { studio, maps }, None)
}

/// Light of the surroundings on an open floor, as the radiance of a white surface there.
pub(crate) fn room_on_floor(lights: &LightRig) -> Vec3 {
    Studio::new(lights).on_open_floor()
}

/// Tangent of the key light's angular radius.
pub(crate) fn key_tangent(lights: &LightRig) -> f32 {
    trig::tan(lights.key.angular_radius.clamp(0.0, 1.0))
}

/// The direction as a unit vector; straight up where it has no length.
pub(crate) fn unit_toward(toward: Vec3) -> Vec3 {
    toward.try_normalize().unwrap_or(Vec3::Y)
}

impl LightRig {
    /// Radiance of the surroundings in a unit direction, without the key light.
    fn radiance(&self, direction: Vec3) -> Vec3 {
        let away = if direction.y >= 0.0 {
            self.zenith
        } else {
            self.nadir
        };
        // The floor's light begins right below the horizon, the sky's grows towards the zenith.
        let share = if direction.y >= 0.0 {
            direction.y
        } else {
            (-direction.y * 3.0).min(1.0)
        };
        let room = Vec3::from(self.horizon).lerp(Vec3::from(away), share);
        self.boxes.iter().fold(room, |light, lamp| {
            let cosine = direction.dot(unit_toward(lamp.toward)).max(0.0);
            light + Vec3::from(lamp.color) * trig::powf(cosine, lamp.focus)
        })
    }
}
