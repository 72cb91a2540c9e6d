//! How a garment is drawn: its surface, faired.
//!
//! The triangles of a garment carry folds of a few edges' length; what lies between neighbors only, a vertex in and
//! the next one out, is no fold that cloth would have but what the mesh cannot carry, and light shows all of it: as
//! specks on a skirt, as teeth along a hem. Passes that shrink and grow in turn take away that and nothing wider
//! (Taubin 1995, "A signal processing approach to fair surface design"). Edges of the cloth and seams are faired
//! along themselves, so that a hem stays where it is cut and the line of a side seam straight.

use glam::Vec3;

use super::Dressed;

/// Shares of the way to the middle of what is beside it that a vertex goes in turn: forth, and back a little more.
/// Twice, what alternates from vertex to vertex keeps a fifth to a third of its height, and a fold of eight edges all but a
/// hundredth.
const SHARES: [f32; 4] = [0.5, -0.53, 0.5, -0.53];

/// Farthest that a vertex is moved [m]: less than the cloth lies over the skin.
const FARTHEST: f32 = 0.003;

/// What is beside each vertex, with seams closed.
#[derive(Debug, Clone, Default)]
pub(super) struct Fairing {
    /// By particle, where its neighbors begin, and one more; none of what stays where it is, and of all but the first
    /// of what is sewn together.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
}

impl Fairing {
    /// Of triangles whose seams are closed, with the pieces of cloth that they are of, and whether each particle is
    /// held where it is.
    pub(super) fn new((triangles, pieces): (&[[u32; 3]], &[u32]), is_held: &[bool]) -> Self {
        let mut sides: Vec<([u32; 2], u32)> = (triangles.iter().zip(pieces))
            .flat_map(|(&[a, b, c], &piece)| [[a, b], [b, c], [c, a]].map(|side| (side, piece)))
            .map(|([a, b], piece)| ([a.min(b), a.max(b)], piece))
            .filter(|([a, b], _)| a != b)
            .collect();
        sides.sort_unstable();
        let mut all = vec![Vec::new(); is_held.len()];
        let (mut along_edges, mut along_seams) = (all.clone(), all.clone());
        for same in sides.chunk_by(|one, next| one.0 == next.0) {
            let ([a, b], piece) = same[0];
            let is_seam = same.iter().any(|&(_, other)| other != piece);
            for [one, other] in [[a, b], [b, a]] {
                all[one as usize].push(other);
                if same.len() == 1 {
                    along_edges[one as usize].push(other);
                }
                if is_seam {
                    along_seams[one as usize].push(other);
                }
            }
        }
        let mut corners = vec![0_u32; is_held.len()];
        for &corner in triangles.iter().flatten() {
            corners[corner as usize] += 1;
        }
        let mut fairing = Self::default();
        let lines = along_edges.iter().zip(&along_seams);
        let rings = all.iter().zip(lines).zip(is_held).zip(&corners);
        for (((ring, (edges, seams)), &is_held), &triangle_count) in rings {
            fairing
                .starts
                .push(super::flat::number(fairing.neighbors.len()));
            let beside: &[u32] = match (edges.len(), seams.len()) {
                _ if is_held => &[],
                (0, 0 | 1) => ring,
                (0, 2) => seams,
                // What belongs to one triangle alone is a corner of the cloth, which stays one.
                (2, _) if 1 < triangle_count => edges,
                _ => &[],
            };
            fairing.neighbors.extend(beside);
        }
        fairing
            .starts
            .push(super::flat::number(fairing.neighbors.len()));
        fairing
    }

    fn beside(&self, particle: usize) -> &[u32] {
        &self.neighbors[self.starts[particle] as usize..self.starts[particle + 1] as usize]
    }

    /// Fairs `places` [m].
    pub(super) fn fair(&self, places: &mut [Vec3]) {
        let before = places.to_vec();
        let mut last = before.clone();
        for share in SHARES {
            last.copy_from_slice(places);
            for (particle, place) in places.iter_mut().enumerate() {
                let beside = self.beside(particle);
                if !beside.is_empty() {
                    let sum: Vec3 = beside.iter().map(|&it| last[it as usize]).sum();
                    *place += (sum / beside.len() as f32 - *place) * share;
                }
            }
        }
        for (place, before) in places.iter_mut().zip(before) {
            *place = before + (*place - before).clamp_length_max(FARTHEST);
        }
    }
}

impl Dressed {
    /// Places as they are drawn: what is sewn together is one point, and the surface is faired [m].
    #[must_use]
    pub fn drawn(&self, positions: &[Vec3]) -> Vec<Vec3> {
        let mut closed = self.closed(positions);
        // Of what is sewn together only the first has neighbors.
        self.fairing.fair(&mut closed);
        let groups = self.welded.iter().map(|&group| closed[group as usize]);
        let mut drawn: Vec<Vec3> = groups.collect();
        self.pucker(&mut drawn);
        drawn
    }

    /// This garment, with what its fairing must know.
    pub(super) fn with_fairing(mut self) -> Self {
        let mut is_held = vec![false; self.start.len()];
        for (particle, &group) in (0..).zip(&self.welded) {
            is_held[group as usize] |= self.is_pinned(particle);
        }
        let weld = |corners: &[u32; 3]| corners.map(|corner| self.welded[corner as usize]);
        let triangles: Vec<[u32; 3]> = self.triangles.iter().map(weld).collect();
        let pieces = (self.triangles.iter()).map(|&[a, ..]| self.panel_of[a as usize]);
        let pieces: Vec<u32> = pieces.collect();
        self.fairing = Fairing::new((&triangles, &pieces), &is_held);
        self
    }
}

#[cfg(test)]
mod tests {
    use lole_geom::trig;

    use super::*;

    const SIDE: u32 = 24;

    /// A square of unit cells, cut into triangles.
    fn square() -> Vec<[u32; 3]> {
        let cells = (0..SIDE - 1).flat_map(|row| (0..SIDE - 1).map(move |column| [row, column]));
        let halves = cells.flat_map(|[row, column]| {
            let [a, b] = [row * SIDE + column, (row + 1) * SIDE + column];
            [[a, b, a + 1], [a + 1, b, b + 1]]
        });
        halves.collect()
    }

    /// The square in two pieces, sewn down its middle.
    fn of_square(is_held: &[bool]) -> Fairing {
        let triangles = square();
        let columns =
            (triangles.iter()).filter_map(|it| it.map(|corner| corner % SIDE).into_iter().min());
        let pieces: Vec<u32> = columns.map(|it| u32::from(SIDE / 2 <= it)).collect();
        Fairing::new((&triangles, &pieces), is_held)
    }

    fn places(height: impl Fn(u32, u32) -> f32) -> Vec<Vec3> {
        let all = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| [row, column]));
        let place = |[row, column]: [u32; 2]| {
            Vec3::new(column as f32, height(row, column), row as f32) * 0.01
        };
        all.map(place).collect()
    }

    /// Within a piece, away from what is faired along itself.
    fn highest(places: &[Vec3]) -> f32 {
        let inner =
            (4..SIDE - 4).flat_map(|row| (4..SIDE / 2 - 4).map(move |column| row * SIDE + column));
        let heights = inner.map(|place| places[place as usize].y.abs());
        heights.fold(0.0, f32::max)
    }

    #[test]
    fn teeth_go_and_folds_stay() {
        let fairing = of_square(&[false; (SIDE * SIDE) as usize]);
        let share = |height: fn(u32, u32) -> f32| {
            let mut faired = places(height);
            let before = highest(&faired);
            fairing.fair(&mut faired);
            highest(&faired) / before
        };
        let teeth = share(|_, column| if column % 2 == 0 { 0.1 } else { -0.1 });
        let fold = share(|_, column| 0.1 * trig::cos(std::f32::consts::TAU * column as f32 / 8.0));
        assert!(teeth < 0.4, "{teeth}");
        assert!((0.95..1.02).contains(&fold), "{fold}");
    }

    #[test]
    fn a_hem_stays_where_it_is_cut() {
        let fairing = of_square(&[false; (SIDE * SIDE) as usize]);
        let flat = places(|_, _| 0.0);
        let mut faired = flat.clone();
        fairing.fair(&mut faired);
        // Two corners of the square have two triangles and are rounded a little.
        let far = |place: u32| {
            let [row, column] = [place / SIDE, place % SIDE];
            let last = SIDE - 1;
            8 < row + (last - column) && 8 < (last - row) + column
        };
        for (place, (before, after)) in (0..).zip(flat.iter().zip(&faired)) {
            let most = if far(place) { 2.0e-6 } else { FARTHEST };
            assert!(before.distance(*after) <= most, "{place}: {before} {after}");
        }
    }

    #[test]
    fn a_seam_is_faired_along_itself() {
        let fairing = of_square(&[false; (SIDE * SIDE) as usize]);
        // A crease down the seam, whose cells lean one way: straight it stays.
        let before = places(|_, column| -(SIDE as f32 / 2.0 - column as f32).abs());
        let mut faired = before.clone();
        fairing.fair(&mut faired);
        let on_seam = (0..SIDE).map(|row| (row * SIDE + SIDE / 2) as usize);
        for place in on_seam.skip(4).take(SIDE as usize - 8) {
            assert!(before[place].distance(faired[place]) < 1.0e-6, "{place}");
        }
    }

    #[test]
    fn nothing_moves_farther_than_it_may_and_what_is_held_stays() {
        let mut is_held = [false; (SIDE * SIDE) as usize];
        let held = (SIDE * SIDE / 2 + SIDE / 2) as usize;
        is_held[held] = true;
        let fairing = of_square(&is_held);
        let before = places(|row, column| if (row + column) % 2 == 0 { 3.0 } else { -3.0 });
        let mut faired = before.clone();
        fairing.fair(&mut faired);
        assert_eq!(before[held], faired[held]);
        for (before, after) in before.iter().zip(&faired) {
            assert!(before.distance(*after) <= FARTHEST * 1.0001);
        }
    }
}
