//! Where the dancers of a group stand.

use glam::Vec3;
use lole_language::{Words, words};

/// How a group stands on stage, as a row of dancers sees its kumu: everybody faces the front.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Formation {
    /// Rows in which everybody is seen between two of the row before her.
    #[default]
    Rows,
    /// One row.
    Line,
    /// One in front, and behind her two by two, ever farther apart.
    Wedge,
    /// Around a circle.
    Circle,
}

/// In rows, so many dancers stand beside each other for each row.
const WIDE: f32 = 2.2;
/// From row to row, over the room of a dancer in her row.
const DEEP: f32 = 0.8;
/// In a wedge, from one to the next behind her: aside and back, over the room of a dancer in a row.
const ASIDE: f32 = 0.6;
const BEHIND: f32 = 0.55;

impl Formation {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Rows, Self::Line, Self::Wedge, Self::Circle];

    /// Its name in commands.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Rows => "rows",
            Self::Line => "line",
            Self::Wedge => "wedge",
            Self::Circle => "circle",
        }
    }

    /// The formation of that name.
    #[must_use]
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|it| it.id() == id)
    }

    /// Its name for people.
    #[must_use]
    pub const fn name(self) -> Words {
        match self {
            Self::Rows => words("互い違いの列", "staggered rows"),
            Self::Line => words("横一列", "one line"),
            Self::Wedge => words("くさび形", "a wedge"),
            Self::Circle => words("輪", "a circle"),
        }
    }

    /// Where `count` dancers stand [m], from the front to the back and from the audience's left to its right, each
    /// with `room` [m] to both neighbors of her row together. Their middle is where one dancer would stand.
    #[must_use]
    pub fn places(self, count: usize, room: f32) -> Vec<Vec3> {
        let rows = match self {
            Self::Circle => return centered(around(count, room)),
            Self::Wedge => return centered(wedge(count, room)),
            Self::Line => vec![count],
            Self::Rows => rows(count),
        };
        let mut places = Vec::with_capacity(count);
        let mut before = None;
        for (depth, &width) in rows.iter().enumerate() {
            // Whoever would stand straight behind another stands beside her: her row is shifted by half a room.
            let is_shifted = before == Some(width % 2);
            before = Some((width + usize::from(is_shifted)) % 2);
            let shift = if is_shifted { 0.5 * room } else { 0.0 };
            let left = 0.5 * room * (width as f32 - 1.0);
            places.extend((0..width).map(|place| {
                let x = room * place as f32 - left + shift;
                Vec3::new(x, 0.0, -DEEP * room * depth as f32)
            }));
        }
        centered(places)
    }
}

/// Who goes to which place of a new formation: for each old place the number of a new one, so that all ways together
/// are short (by their squares) and no two of them cross.
///
/// Who changes places with whom is tried until no pair gains by it. Shortest sums of squares keep those who walk at
/// the same time apart (Turpin, Michael and Kumar 2014, doi 10.1007/s10514-014-9412-1).
#[must_use]
pub fn assign_places(from: &[Vec3], to: &[Vec3]) -> Vec<usize> {
    let mut goes: Vec<usize> = (0..from.len().min(to.len())).collect();
    let cost = |one: usize, place: usize| from[one].distance_squared(to[place]);
    let mut changed = true;
    while changed {
        changed = false;
        for one in 0..goes.len() {
            for other in one + 1..goes.len() {
                let [a, b] = [goes[one], goes[other]];
                if cost(one, b) + cost(other, a) + 1.0e-6 < cost(one, a) + cost(other, b) {
                    goes.swap(one, other);
                    changed = true;
                }
            }
        }
    }
    goes
}

/// Widths of rows from the front, the wider ones behind.
fn rows(count: usize) -> Vec<usize> {
    let mut depth = 1;
    while WIDE * ((depth * depth) as f32) < count as f32 {
        depth += 1;
    }
    (0..depth).map(|row| (count + row) / depth).collect()
}

/// One in front and two by two behind her, nobody straight behind another.
fn wedge(count: usize, room: f32) -> Vec<Vec3> {
    let place = |number: usize| {
        let depth = number.div_ceil(2) as f32;
        let side = if number % 2 == 1 { -1.0 } else { 1.0 };
        room * depth * Vec3::new(ASIDE * side, 0.0, -BEHIND)
    };
    (0..count).map(place).collect()
}

/// Places around a circle whose neighbors have the room of a row, the first in front.
fn around(count: usize, room: f32) -> Vec<Vec3> {
    let step = std::f32::consts::TAU / count.max(1) as f32;
    let radius = match count {
        0 | 1 => 0.0,
        _ => 0.5 * room / lole_geom::trig::sin(0.5 * step),
    };
    let place = |turn: usize| {
        let (sin, cos) = lole_geom::trig::sin_cos(step * turn as f32);
        Vec3::new(-sin, 0.0, cos) * radius
    };
    (0..count).map(place).collect()
}

/// The places moved so that the middle of their extent is at the origin.
fn centered(mut places: Vec<Vec3>) -> Vec<Vec3> {
    let (low, high) = places
        .iter()
        .fold((Vec3::MAX, Vec3::MIN), |(low, high), place| {
            (low.min(*place), high.max(*place))
        });
    for place in &mut places {
        *place -= 0.5 * (low + high);
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every pair of places.
    fn pairs(places: &[Vec3]) -> impl Iterator<Item = (Vec3, Vec3)> + '_ {
        let numbered = places.iter().enumerate();
        numbered.flat_map(|(number, &one)| places[number + 1..].iter().map(move |it| (one, *it)))
    }

    #[test]
    fn everybody_has_her_room_in_every_formation() {
        for formation in Formation::ALL {
            for count in 1..=40 {
                let places = formation.places(count, 1.5);
                assert_eq!(places.len(), count, "{formation:?}");
                let nearest = pairs(&places).map(|(one, other)| one.distance(other));
                let nearest = nearest.fold(f32::INFINITY, f32::min);
                assert!(1.19 < nearest, "{formation:?} of {count}: {nearest} m");
            }
        }
    }

    #[test]
    fn a_group_stands_around_the_place_of_one_dancer() {
        for formation in Formation::ALL {
            assert_eq!(formation.places(1, 1.5), [Vec3::ZERO], "{formation:?}");
            for count in 2..=40 {
                let places = formation.places(count, 1.5);
                let low = places.iter().fold(Vec3::ZERO, |low, place| low.min(*place));
                let high = places
                    .iter()
                    .fold(Vec3::ZERO, |high, place| high.max(*place));
                assert!((low + high).length() < 1.0e-4, "{formation:?} of {count}");
            }
        }
    }

    #[test]
    fn nobody_of_a_staggered_row_hides_behind_the_row_before_her() {
        for count in 2..=40 {
            let places = Formation::Rows.places(count, 1.5);
            for one in &places {
                let next = places.iter().filter(|it| (it.z - one.z - 1.2).abs() < 0.01);
                for before in next {
                    let aside = (before.x - one.x).abs();
                    assert!(0.7 < aside, "{count}: {aside} m");
                }
            }
        }
    }

    #[test]
    fn nobody_of_a_wedge_stands_straight_behind_another() {
        for count in 2..=40 {
            let places = Formation::Wedge.places(count, 1.5);
            let aside = pairs(&places).map(|(one, other)| (one.x - other.x).abs());
            let aside = aside.fold(f32::INFINITY, f32::min);
            assert!(0.8 < aside, "{count}: {aside} m");
        }
    }

    /// The nearest that two come who all walk at the same time from one formation to another [m].
    fn nearest_on_the_way(from: &[Vec3], to: &[Vec3], goes: &[usize]) -> f32 {
        let shares = (0..=20_u8).map(|step| f32::from(step) / 20.0);
        let nearest = shares.map(|share| {
            let now = from.iter().zip(goes);
            let now: Vec<Vec3> = now.map(|(at, &place)| at.lerp(to[place], share)).collect();
            let apart = pairs(&now).map(|(one, other)| one.distance(other));
            apart.fold(f32::INFINITY, f32::min)
        });
        nearest.fold(f32::INFINITY, f32::min)
    }

    #[test]
    fn everybody_finds_a_place_of_her_own_and_meets_nobody_on_the_way() {
        let formations = Formation::ALL.iter();
        for (from, to) in
            formations.flat_map(|from| Formation::ALL.iter().map(move |to| (from, to)))
        {
            for count in 1..=24 {
                let [from, to] = [from, to].map(|it| it.places(count, 1.5));
                let goes = assign_places(&from, &to);
                let mut taken = goes.clone();
                taken.sort_unstable();
                assert_eq!(taken, (0..count).collect::<Vec<usize>>());
                let nearest = nearest_on_the_way(&from, &to, &goes);
                assert!(0.6 < nearest, "{count}: {nearest} m");
            }
        }
    }

    #[test]
    fn names_are_read_back() {
        for formation in Formation::ALL {
            assert_eq!(Formation::from_id(formation.id()), Some(formation));
        }
    }
}
