//! Strands: lines of mass points that hang, swing and lie on a body, such as a lei, raffia or leaves.
//!
//! A strand is known by its mass per length, its bending stiffness `EI` and how far its middle keeps
//! from skin. It does not stretch. Substeps are small and every constraint is solved once in each
//! (Macklin and others 2019, "Small Steps in Physics Simulation"); of `n` particles and substeps of `h`
//! a strand gives by about `g h² n² / 2` along it and, where it stands out stiffly, `g h² n⁴ / 8` across.
//! Strands do not meet each other but
//! by [`Link`]s, which keep chosen particles between two distances: enough for leaves that lie in
//! layers. Twist is not computed: what is drawn on a strand is carried along it without turning.

mod contact;
mod solve;

use glam::Vec3;
use lole_geom::Surfel;

use crate::lost::{Lost, check_cloth};
use crate::step::Progress;
use contact::Contacts;

/// Whether the end of a strand is tied to its beginning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ring {
    /// The strand has two ends.
    #[default]
    Open,
    /// The last particle is followed by the first.
    Closed,
}

/// One strand, where and how it begins.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Strand {
    /// Its particles at the start [m]; at least 2, of a ring 3.
    pub positions: Vec<Vec3>,
    /// Distance between neighbors [m].
    pub spacing: f32,
    /// Whether it is a ring.
    pub ring: Ring,
    /// Particles that are carried, by their number in the strand, ascending.
    pub pinned: Vec<u32>,
    /// Mass per length [kg/m].
    pub linear_density: f32,
    /// Bending stiffness `EI` [N·m²]; 0 for a thread.
    pub bend_stiffness: f32,
    /// Distance that its middle keeps from skin [m].
    pub contact_offset: f32,
}

/// Two particles that stay between two distances from each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// Numbers of the particles among those of all strands.
    pub particles: [u32; 2],
    /// Least and largest distance [m].
    pub range: [f32; 2],
    /// Distance by which a force of 1 N overcomes it [m/N].
    pub compliance: f32,
}

/// A particle drawn to a place that a body carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tie {
    /// Number of the particle among those of all strands.
    pub particle: u32,
    /// Distance by which a force of 1 N overcomes it [m/N].
    pub compliance: f32,
}

/// Why strands cannot be prepared.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StrandError {
    /// A strand of too few particles.
    #[error("strand {strand} has {count} particles; it needs {least}")]
    TooShort {
        /// Place of the strand in the list.
        strand: usize,
        /// Particles that it has.
        count: usize,
        /// Particles that it needs.
        least: usize,
    },
    /// A number that is not finite or out of its range.
    #[error("`{field}` of strand {strand} is {value}; it must be {rule}")]
    OutOfRange {
        /// Place of the strand in the list.
        strand: usize,
        /// The number's name.
        field: &'static str,
        /// What it is.
        value: f32,
        /// What it may be.
        rule: &'static str,
    },
    /// A pin, a link or a tie to a particle that does not exist.
    #[error("there is no particle {particle} among {count}")]
    NoSuchParticle {
        /// The particle named.
        particle: u32,
        /// Particles there are.
        count: usize,
    },
}

/// Strands prepared for stepping: what never changes.
#[derive(Debug, Clone, PartialEq)]
pub struct StrandModel {
    /// First particle of every strand, and one more.
    starts: Vec<usize>,
    rings: Vec<Ring>,
    /// By strand [m].
    spacings: Vec<f32>,
    /// By strand `spacing³ / EI` [m/N]; infinite for a thread.
    bend_compliances: Vec<f32>,
    /// By particle [1/kg]; 0 where pinned.
    inv_masses: Vec<f32>,
    /// By particle [m].
    contact_offsets: Vec<f32>,
    /// Ascending.
    pins: Vec<u32>,
    links: Vec<Link>,
    ties: Vec<Tie>,
}

/// Everything about strands that changes from step to step.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StrandState {
    /// Particles of all strands, one strand after the other [m].
    pub positions: Vec<Vec3>,
    /// Velocities of the particles [m/s].
    pub velocities: Vec<Vec3>,
    /// Where the body was left; empty before the first step.
    surfels: Vec<Surfel>,
    contacts: Contacts,
    /// Room for the positions at the start of a substep, and at that of a step.
    before: [Vec<Vec3>; 2],
}

/// What the user turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrandConfig {
    /// Time slices of a step. More let strands stretch less and cost more.
    pub substep_count: u32,
    /// Acceleration of free fall [m/s²].
    pub gravity: Vec3,
    /// Air drag as a rate [1/s].
    pub drag_rate: f32,
    /// Coulomb friction coefficient on the body.
    pub friction: f32,
    /// Fastest that a particle in the body is pushed out [m/s].
    pub depenetration_speed: f32,
}

impl Default for StrandConfig {
    fn default() -> Self {
        Self {
            substep_count: 12,
            gravity: Vec3::new(0.0, -9.81, 0.0),
            drag_rate: 1.0,
            friction: 0.4,
            depenetration_speed: 1.0,
        }
    }
}

/// What the world does during one step; by default nothing is in it.
#[derive(Debug, Clone, Copy, Default)]
pub struct StrandInput<'a> {
    /// Where the pinned particles are at the end of the step [m], ascending.
    pub pins: &'a [Vec3],
    /// Where the tied ones are drawn to [m], in the order of the ties.
    pub ties: &'a [Vec3],
    /// The body at the end of the step; always the same surfels in the same order.
    pub surfels: &'a [Surfel],
    /// Velocity of the air [m/s].
    pub air_velocity: Vec3,
}

impl StrandModel {
    /// Prepares strands.
    ///
    /// # Errors
    /// A strand that is too short, a number out of its range, a particle that does not exist.
    pub fn new(strands: &[Strand], links: &[Link], ties: &[Tie]) -> Result<Self, StrandError> {
        let mut model = Self {
            starts: vec![0],
            rings: Vec::new(),
            spacings: Vec::new(),
            bend_compliances: Vec::new(),
            inv_masses: Vec::new(),
            contact_offsets: Vec::new(),
            pins: Vec::new(),
            links: links.to_vec(),
            ties: ties.to_vec(),
        };
        for (place, strand) in strands.iter().enumerate() {
            check(place, strand)?;
            model.push(strand)?;
        }
        let count = model.inv_masses.len();
        let named = links.iter().flat_map(|link| link.particles);
        let named = named.chain(ties.iter().map(|tie| tie.particle));
        match { named }.find(|&particle| count <= particle as usize) {
            Some(particle) => Err(StrandError::NoSuchParticle { particle, count }),
            None => Ok(model),
        }
    }

    fn push(&mut self, strand: &Strand) -> Result<(), StrandError> {
        let (first, count) = (self.inv_masses.len(), strand.positions.len());
        let inv_mass = 1.0 / (strand.linear_density * strand.spacing);
        self.inv_masses.resize(first + count, inv_mass);
        self.contact_offsets
            .resize(first + count, strand.contact_offset);
        if strand.ring == Ring::Open {
            // Half a spacing of strand belongs to each end.
            self.inv_masses[first] *= 2.0;
            self.inv_masses[first + count - 1] *= 2.0;
        }
        for &pin in &strand.pinned {
            if count <= pin as usize {
                let particle = pin;
                return Err(StrandError::NoSuchParticle { particle, count });
            }
            self.inv_masses[first + pin as usize] = 0.0;
            self.pins
                .push(u32::try_from(first).unwrap_or(u32::MAX).saturating_add(pin));
        }
        self.starts.push(first + count);
        self.rings.push(strand.ring);
        self.spacings.push(strand.spacing);
        let cube = strand.spacing * strand.spacing * strand.spacing;
        self.bend_compliances.push(cube / strand.bend_stiffness);
        Ok(())
    }

    /// The strands with these particles carried as the pinned ones are, by their numbers among those of all; one
    /// that does not exist changes nothing.
    #[must_use]
    pub fn with_held(mut self, held: &[u32]) -> Self {
        for &particle in held {
            let inv_mass = self.inv_masses.get_mut(particle as usize);
            if let (Some(inv_mass), Err(place)) = (inv_mass, self.pins.binary_search(&particle)) {
                *inv_mass = 0.0;
                self.pins.insert(place, particle);
            }
        }
        self
    }

    /// Particles of all strands.
    #[must_use]
    pub const fn particle_count(&self) -> usize {
        self.inv_masses.len()
    }

    /// Particles of each strand among those of all.
    pub fn strands(&self) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        self.starts.windows(2).map(|ends| ends[0]..ends[1])
    }

    /// Whether each strand is a ring.
    #[must_use]
    pub fn rings(&self) -> &[Ring] {
        &self.rings
    }

    /// Whether any particle is drawn to the body.
    #[must_use]
    pub const fn is_tied(&self) -> bool {
        !self.ties.is_empty()
    }

    /// Pinned particles, ascending.
    #[must_use]
    pub fn pins(&self) -> &[u32] {
        &self.pins
    }
}

fn check(strand: usize, of: &Strand) -> Result<(), StrandError> {
    let least = match of.ring {
        Ring::Open => 2,
        Ring::Closed => 3,
    };
    let count = of.positions.len();
    if count < least {
        return Err(StrandError::TooShort {
            strand,
            count,
            least,
        });
    }
    let positive = f32::MIN_POSITIVE..f32::INFINITY;
    let rows = [
        ("spacing", of.spacing, true),
        ("linear_density", of.linear_density, true),
        ("bend_stiffness", of.bend_stiffness, false),
        ("contact_offset", of.contact_offset, false),
    ];
    for (field, value, is_positive) in rows {
        if !(positive.contains(&value) || (!is_positive && value == 0.0)) {
            let rule = if is_positive {
                "finite and above 0"
            } else {
                "finite and not negative"
            };
            return Err(StrandError::OutOfRange {
                strand,
                field,
                value,
                rule,
            });
        }
    }
    let broken = of.positions.iter().find(|position| !position.is_finite());
    broken.map_or(Ok(()), |_| {
        Err(StrandError::OutOfRange {
            strand,
            field: "positions",
            value: f32::NAN,
            rule: "finite",
        })
    })
}

impl StrandState {
    /// Strands at rest where they begin; they have as many particles as the model.
    #[must_use]
    pub fn new(strands: &[Strand]) -> Self {
        let positions: Vec<Vec3> = strands
            .iter()
            .flat_map(|strand| strand.positions.iter().copied())
            .collect();
        Self {
            velocities: vec![Vec3::ZERO; positions.len()],
            positions,
            ..Self::default()
        }
    }

    /// Root mean square of the speeds [m/s].
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "particles are fewer than 2^24")]
    pub fn rms_speed(&self) -> f32 {
        let squares: f32 = self.velocities.iter().map(|v| v.length_squared()).sum();
        (squares / self.velocities.len().max(1) as f32).sqrt()
    }
}

/// One step of strands.
#[derive(Clone, Copy)]
struct StrandStep<'a> {
    model: &'a StrandModel,
    config: &'a StrandConfig,
    input: &'a StrandInput<'a>,
}

/// Moves strands on by `dt` [s].
///
/// # Errors
/// A state of other strands, and the first particle that would be at no place; all of them are where they were,
/// at rest after the latter.
pub fn step(
    model: &StrandModel,
    config: &StrandConfig,
    input: &StrandInput<'_>,
    state: &mut StrandState,
    dt: f32,
) -> Result<(), Lost> {
    check_cloth(0, [model.inv_masses.len(), state.positions.len()])?;
    if state.surfels.len() != input.surfels.len() {
        state.surfels.clear();
        state.surfels.extend_from_slice(input.surfels);
    }
    let [_, kept] = &mut state.before;
    kept.clone_from(&state.positions);
    let step = StrandStep {
        model,
        config,
        input,
    };
    let flight = contact::Flight {
        positions: &state.positions,
        velocities: &state.velocities,
        dt,
    };
    state.contacts.find(step, &state.surfels, &flight);
    let count = config.substep_count.max(1);
    #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
    let h = dt / count as f32;
    for index in 0..count {
        #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
        let [from, to] = [index, index + 1].map(|end| end as f32 / count as f32);
        solve::predict(step, state, h);
        solve::place_pins(model, input, state, (to - from) / (1.0 - from));
        solve::bend(model, state, h);
        solve::link(model, state, h);
        solve::tie(model, input, state, h);
        solve::stretch(model, state);
        let StrandState {
            contacts,
            positions,
            before,
            ..
        } = state;
        let progress = Progress {
            fraction: to,
            share: to - from,
        };
        contacts.push_out(step, [positions, &mut before[0]], progress, h);
        solve::update_velocities(state, h);
    }
    state.surfels.clear();
    state.surfels.extend_from_slice(input.surfels);
    let all = state.positions.iter().zip(&state.velocities);
    let is_lost =
        |(position, velocity): (&Vec3, &Vec3)| !(position.is_finite() && velocity.is_finite());
    if let Some(particle) = all.into_iter().position(is_lost) {
        state.positions.clone_from(&state.before[1]);
        state.velocities.fill(Vec3::ZERO);
        return Err(Lost::Strand { particle });
    }
    Ok(())
}
