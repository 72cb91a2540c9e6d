//! Everything that is worn as it is drawn and recorded.

use glam::Vec3;

use super::Performance;
use super::dressed::Dressed;
use crate::{Vertices, Worn};

impl Performance {
    /// Positions of everything that moves by itself [m]: of gathered cloth, then of what is sewn from shaped
    /// pieces, then of strands.
    pub fn particles(&self) -> impl Iterator<Item = &Vec3> {
        let sewn = self.dressed.iter().flat_map(Dressed::positions);
        let strands = self.adorned.positions().flatten();
        self.cloth_positions.iter().chain(sewn).chain(strands)
    }

    /// Everything that is worn or held as it is drawn, surface by surface as [`Production::surfaces`](crate::Production::surfaces) has them.
    #[must_use]
    pub fn surfaces(&self) -> Vec<Vertices> {
        self.surfaces_of(&self.cloth_positions)
    }

    /// The same with gathered cloth at `gathered` [m].
    pub(crate) fn surfaces_of(&self, gathered: &[Vec3]) -> Vec<Vertices> {
        let production = &self.production;
        let pressed = self.pressed(gathered);
        let cloths = production.garments.iter();
        let cloths = cloths.map(|it| it.mesh.vertices(&pressed[it.particles.clone()]));
        let sewn = (0..production.dressed.len()).map(|place| self.dressed_vertices(place));
        let beside = self.adorned.posed(production, &self.world_from_bind);
        cloths.chain(sewn).chain(beside).collect()
    }

    /// What moves of every surface by itself [m], as files keep it: particles of gathered rectangles as they
    /// are seen, drawn vertices of everything else; empty where bones carry all of it.
    #[must_use]
    pub fn recorded(&self) -> Vec<Vec<Vec3>> {
        let production = &self.production;
        let pressed = self.pressed(&self.cloth_positions);
        let gathered = production.garments.iter();
        let gathered = gathered.map(|it| pressed[it.particles.clone()].to_vec());
        let sewn = production.dressed.iter().zip(&self.dressed);
        let sewn = sewn.map(|(garment, moving)| garment.dressed.drawn(moving.positions()));
        let beside = production.adornments.iter().map(Worn::Beside);
        let posed = self.adorned.posed(production, &self.world_from_bind);
        let posed = beside.flat_map(Worn::surfaces).zip(posed);
        let posed = posed.map(|(surface, [vertices, _])| {
            if surface.rides_on_bones() {
                Vec::new()
            } else {
                vertices
            }
        });
        gathered.chain(sewn).chain(posed).collect()
    }
}
