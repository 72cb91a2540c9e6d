//! Where everything that is drawn is in one moment.

use glam::{Affine3A, Vec3};
use lole_body::{Dancer, Expression, Swing};
use lole_geom::finer::Finer;
use lole_render::Material;
use lole_stage::{Performance, Production, Vertices};

use crate::{Looks, alive};

/// Dancer and what she wears in one moment, as they are drawn.
#[derive(Debug, Clone, Copy)]
pub struct DrawnDancer<'a> {
    /// What she wears or holds, surface by surface as [`Production::surfaces`] has them.
    pub worn: &'a [Vertices],
    /// Linear color factors of their vertices, by surface; empty, or of a surface empty, where it has its own
    /// colors.
    pub colors: &'a [Vec<Vec3>],
    /// What a surface with such colors is made of instead of its own; `None` where it keeps it.
    pub colored: Option<&'a Material>,
    /// The posed body: vertices [m] and their normals.
    pub body: [&'a [Vec3]; 2],
    /// Single strands of her hair, in the same way; empty where they are not drawn.
    pub strands: [&'a [Vec3]; 2],
}

/// The body as it is drawn in a pose, with what face and hair do.
#[must_use]
pub fn drawn_body(
    dancer: &Dancer,
    world_from_bind: &[Affine3A],
    (expression, swing): (Expression, &Swing),
) -> Vertices {
    let mut body = Vertices::default();
    let [positions, normals] = &mut body;
    dancer.pose_drawn(world_from_bind, expression, (positions, normals));
    if let Some(drawn) = &dancer.drawn_body {
        drawn.open_hair.swing_mesh(swing, (positions, normals));
    }
    body
}

/// One frame, kept to be drawn.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Moment {
    /// What she wears or holds, surface by surface as [`Production::surfaces`] has them.
    pub worn: Vec<Vertices>,
    /// The body.
    pub body: Vertices,
    /// Single strands of her hair, where it is photographed; else empty.
    pub strands: Vertices,
}

impl Moment {
    /// The present frame of a performance.
    #[must_use]
    pub fn of(performance: &Performance) -> Self {
        Self::among(performance, 0.0)
    }

    /// The present frame of one of several who dance together: she blinks by a clock that is so much fast [s].
    #[must_use]
    pub fn among(performance: &Performance, fast: f32) -> Self {
        let now = alive::expression(performance, fast);
        Self::with(performance, now)
    }

    /// The present frame of a performance as it is photographed from near by: nobody blinks, hair has its strands, and
    /// her skin and what is sewn are rounded where `looks` are those of [`Looks::photographed`].
    #[must_use]
    pub fn photographed(performance: &Performance, looks: &Looks) -> Self {
        let mut moment = Self::still(performance);
        let rounded = |surface: &mut Vertices, finer: &Finer| {
            let [positions, normals] = &*surface;
            *surface = finer.rounded([positions, normals]);
        };
        if let Some(skin) = &looks.finer_skin {
            rounded(&mut moment.body, &skin.finer);
        }
        for (worn, cover) in moment.worn.iter_mut().zip(&looks.worn) {
            if let Some(cover) = &cover.finer {
                rounded(worn, &cover.finer);
            }
        }
        moment
    }

    /// The same from where corners of triangles are not seen, as of a whole group.
    #[must_use]
    pub fn still(performance: &Performance) -> Self {
        let now = Expression {
            closed: 0.0,
            ..alive::expression(performance, 0.0)
        };
        let mut moment = Self::with(performance, now);
        if let Some(drawn) = &performance.production().dancer.drawn_body {
            let [positions, normals] = &mut moment.strands;
            (drawn.strands).pose(performance.world_from_bind(), positions, normals);
            (drawn.open_hair).swing_strands(&performance.swing(), (positions, normals));
        }
        moment
    }

    fn with(performance: &Performance, expression: Expression) -> Self {
        let production = performance.production();
        let body = drawn_body(
            &production.dancer,
            performance.world_from_bind(),
            (expression, &performance.swing()),
        );
        Self::new(production, performance.surfaces(), body)
    }

    /// What is worn and a posed body, whose flesh gives way to what lies in it.
    #[must_use]
    pub fn new(production: &Production, worn: Vec<Vertices>, mut body: Vertices) -> Self {
        let [positions, normals] = &mut body;
        lole_stage::give_way(production, &worn, (positions, normals));
        Self {
            worn,
            body,
            strands: Vertices::default(),
        }
    }

    /// All of its surfaces.
    pub(crate) fn surfaces(&self) -> impl Iterator<Item = &Vertices> {
        self.worn.iter().chain([&self.body, &self.strands])
    }

    /// A moment of the same between this one and another, at a share of the way.
    pub(crate) fn towards(&self, other: &Self, share: f32) -> Self {
        let between = |from: &Vertices, to: &Vertices| -> Vertices {
            std::array::from_fn(|column| {
                let pairs = from[column].iter().zip(&to[column]);
                pairs.map(|(from, to)| from.lerp(*to, share)).collect()
            })
        };
        let worn = self.worn.iter().zip(&other.worn);
        Self {
            worn: worn.map(|(from, to)| between(from, to)).collect(),
            body: between(&self.body, &other.body),
            strands: between(&self.strands, &other.strands),
        }
    }

    /// The same, so far elsewhere on the stage [m].
    #[must_use]
    pub fn moved(mut self, by: Vec3) -> Self {
        let surfaces = (self.worn.iter_mut()).chain([&mut self.body, &mut self.strands]);
        for place in surfaces.flat_map(|[positions, _]| positions) {
            *place += by;
        }
        self
    }

    /// What is drawn of it; everything in its own colors.
    #[must_use]
    pub fn dancer(&self) -> DrawnDancer<'_> {
        DrawnDancer {
            worn: &self.worn,
            colors: &[],
            colored: None,
            body: [&self.body[0], &self.body[1]],
            strands: [&self.strands[0], &self.strands[1]],
        }
    }
}
