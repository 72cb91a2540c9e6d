//! The bodice block: a flat front and back of the trunk from neck to waist, which fitted garments are
//! drafted from.
//!
//! It is laid out as the published blocks of Bunka Fashion College (women, 2000) and of Aldrich's
//! "Metric Pattern Cutting" are, with the tape's own widths and lengths where those have the bust's:
//!
//! ```text
//!  neck width       n  = N / 5 - 0.2 cm           (Aldrich), back + 0.2, back rise n / 3, front depth n + 0.5
//!  depth of armhole s  = B / 12 + 13.7 cm         (Bunka), at most 0.56 of the back length (children)
//!  half width          = (B + ease) / 2 = back + armhole + chest, ease 25 : 60 : 15 %
//!  shoulder            : to half the shoulder breadth, its drop 0.9 in the back and 1.1 in front
//!  side seam           : in the middle of the armhole
//!  bust dart           : pivoted about the bust point from the armhole into the side seam; as wide as makes
//!                        the front armhole 16.5 % shallower than the back one, which is what closing
//!                        Bunka's dart of (B / 4 - 2.5)° does at a bust of 83 cm, and less where bust and
//!                        the girth below it differ less
//! ```
//!
//! The center line lies at `x = 0`, the waist at `y = 0`, `+x` to the wearer's left, in meters. Pivoting is
//! a rotation, so both sides of every seam stay as long as they were.

use kurbo::{Affine, PathSeg, Point, Vec2};
use lole_geom::trig64;
use lole_language::words;
use lole_pattern::{Alteration, Alterations, DraftError, Measure, Measures};

use super::shape::{CM, at, curve, length, line};

/// What a garment asks of its block, in meters.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fit {
    /// Finished garment over the bust girth.
    pub(crate) bust_ease: f64,
    /// Neckline from the side of the neck along the shoulder.
    pub(crate) neck_widened: f64,
    /// Neckline below the pit of the neck, and below the nape.
    pub(crate) neck_dropped: [f64; 2],
    /// Armhole deeper than the block's.
    pub(crate) armhole_dropped: f64,
    /// What a trial has shown.
    pub(crate) alterations: Alterations,
}

/// A block: lines in the order and direction of a piece's edges, counterclockwise.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    pub(crate) front: Half,
    pub(crate) back: Half,
    pub(crate) bust_point: Point,
    /// Angle that the part of the front above the side dart is turned about the bust point.
    pub(crate) dart_angle: f64,
    /// Height of the armhole's lowest level over the waist, before the front is pivoted.
    pub(crate) bust_line: f64,
    /// What is folded out of the middle of the back over the waist.
    pub(crate) folded_out: f64,
}

/// The left half of a front or back.
#[derive(Debug, Clone)]
pub(crate) struct Half {
    /// Lower end of the armhole, where it meets the side.
    pub(crate) underarm: Point,
    /// From the underarm up to the shoulder point.
    pub(crate) armhole: Vec<PathSeg>,
    /// Where the armhole runs upright: the narrowest chest or back.
    pub(crate) narrowest: Point,
    pub(crate) shoulder: [Point; 2],
    /// From the shoulder to the center line.
    pub(crate) neckline: Vec<PathSeg>,
    /// Where the neckline meets the center line.
    pub(crate) center: Point,
}

/// Measures that a block is drafted from.
pub(crate) const MEASURES: &[Measure] = &[
    Measure::BustGirth,
    Measure::UnderbustGirth,
    Measure::WaistGirth,
    Measure::NeckGirth,
    Measure::UpperArmGirth,
    Measure::ShoulderBreadth,
    Measure::BackLength,
    Measure::FrontLength,
    Measure::ShoulderDrop,
    Measure::BackBreadth,
    Measure::ChestBreadth,
    Measure::BustPointBreadth,
    Measure::BustHeight,
    Measure::WaistHeight,
];

/// Depth of the armhole over the back length, at most.
const DEEPEST_ARMHOLE: f64 = 0.56;
/// Shares of the ease that back and chest get; the armhole gets the rest.
const EASE_OF_BACK: f64 = 0.25;
const EASE_OF_CHEST: f64 = 0.15;
/// How much shallower the front armhole is where bust and the girth below it differ fully.
const SHALLOWER_FRONT: f64 = 0.165;
/// Bust over the girth below it where they differ fully, as a share of the bust.
const FULL_CUP: f64 = 0.138;
/// Arms over the bust above which the arm was measured wrong, and not the bust.
const THICKEST_ARM: f64 = 0.40;
/// What the widest dart leaves of the front's length goes into a deeper front armhole, up to this [m].
const LONGER_FRONT: f64 = 4.0 * CM;
/// Widest dart [rad]: beyond it the side seam would lie across the chest.
const WIDEST_DART: f64 = 0.52;
/// Back shoulder eased into the front one, for the shoulder blades: this much, or this share of it.
const SHOULDER_EASE: f64 = 0.5 * CM;
const SHARE_OF_SHOULDER: f64 = 0.05;
/// A front that is raised by less than this needs no dart: it is eased into the armhole.
const LEAST_RISE: f64 = 0.4 * CM;
/// The front length runs over the bust and a little aslant.
const ASLANT: f64 = 0.5 * CM;

impl Block {
    /// Drafts the block.
    ///
    /// # Errors
    /// A measure that is no number of its band, or that does not go with the others.
    pub(crate) fn new(measures: &Measures, fit: &Fit) -> Result<Self, DraftError> {
        measures.check(MEASURES)?;
        let widths = Widths::new(measures, fit)?;
        let lengths = Lengths::new(measures, fit, &widths)?;
        let back_shoulder = widths.shoulder_line(&lengths, Side::Back);
        // The front hangs as it does, however round the back is.
        let unaltered_back = widths.shoulder_line(&lengths.of_upright_back(), Side::Back);
        let front_shoulder = widths.shoulder_line(&lengths, Side::Front);
        let back_underarm = at(widths.back + 0.5 * widths.armhole, lengths.bust_line);
        let flat_front = widths.chest + 0.5 * (widths.armhole + widths.full_bust);
        let flat_underarm = at(flat_front, lengths.bust_line);
        let bust_point = at(0.5 * measures.bust_point_breadth.to_m(), lengths.bust_point);
        let dart_angle = dart_angle(
            measures,
            (flat_underarm, bust_point),
            [unaltered_back[0].y, front_shoulder[0].y],
            lengths.bust_line,
        )?;
        let back = Half::new(back_underarm, 0.0, widths.back, back_shoulder, {
            let center = at(0.0, lengths.nape + lengths.rounded - fit.neck_dropped[1]);
            (center, fit.neck_widened)
        });
        let underarm = Affine::rotate_about(dart_angle, bust_point) * flat_underarm;
        let front = Half::new(underarm, dart_angle, widths.chest, front_shoulder, {
            let pit = lengths.front_neck - (widths.neck + 0.5 * CM);
            (at(0.0, pit - fit.neck_dropped[0]), fit.neck_widened)
        });
        let block = Self {
            front,
            back,
            bust_point,
            dart_angle,
            bust_line: lengths.bust_line,
            folded_out: fit.alterations.of(Alteration::SwayBack).to_m(),
        };
        block.check(measures)?;
        Ok(block)
    }

    /// Armholes, necklines and shoulders must run as those of a garment do.
    fn check(&self, measures: &Measures) -> Result<(), DraftError> {
        for half in [&self.back, &self.front] {
            let [tip, neck] = half.shoulder;
            let run = tip.x - neck.x;
            let steep = (neck.y - tip.y) / STEEPEST_SHOULDER;
            if run < LEAST_SHOULDER.max(steep) {
                let missing = LEAST_SHOULDER.max(steep) - run;
                let least = measures.shoulder_breadth.to_m() + 2.0 * missing;
                return Err(unfit(
                    Measure::ShoulderBreadth,
                    measures,
                    [least, Measure::ShoulderBreadth.band_cm()[1] * CM],
                    words(
                        "。または衿ぐりを狭くしてください",
                        ", or make the neckline narrower",
                    ),
                ));
            }
            if neck.y - half.center.y < LEAST_NECK_DEPTH
                || half.center.y < LOWEST_NECK * self.bust_line
            {
                let length = measures.front_length.to_m();
                let more = LOWEST_NECK * self.bust_line - half.center.y;
                return Err(unfit(
                    Measure::FrontLength,
                    measures,
                    [length + more, Measure::FrontLength.band_cm()[1] * CM],
                    words(
                        "。または衿ぐりを浅くしてください",
                        ", or make the neckline shallower",
                    ),
                ));
            }
        }
        Ok(())
    }

    /// The middle of the back from `from` down to a level, of hips at `hip_y`. A fold that is taken out over the
    /// waist turns what is below about the side: the seam comes in at the waist by as much as both angles are.
    pub(crate) fn middle_of_back(&self, from: Point, hip_y: f64, foot_y: f64) -> Vec<PathSeg> {
        if self.folded_out <= 0.0 {
            return vec![line(from, at(0.0, foot_y))];
        }
        let foot_y = foot_y.min(-CM);
        let (over, below) = (self.bust_line.min(from.y - 1.0 * CM), -hip_y);
        let turned = self.folded_out / self.back.underarm.x;
        let inwards = turned * over * below / (over + below);
        let (blades, waist) = (at(0.0, over), at(inwards, 0.0));
        let down = |reach: f64| Vec2::new(0.0, -0.4 * reach);
        let mut way = vec![
            line(from, blades),
            curve(blades, down(over), down(over), waist),
        ];
        if foot_y < hip_y {
            let hip = at(0.0, hip_y);
            way.push(curve(waist, down(below), down(below), hip));
            way.push(line(hip, at(0.0, foot_y)));
        } else {
            let share = foot_y / hip_y;
            let left = 1.0 - share * share * (3.0 - 2.0 * share);
            let foot = at(inwards * left, foot_y);
            way.push(curve(waist, down(-foot_y), down(-foot_y), foot));
        }
        way
    }

    /// Both halves of the neckline, closed [m].
    pub(crate) fn neckline_length(&self) -> f64 {
        2.0 * (length(&self.front.neckline) + length(&self.back.neckline))
    }
}

/// Shoulder that is left beside the neckline [m], horizontally.
const LEAST_SHOULDER: f64 = 1.5 * CM;
/// Drop of a shoulder over its run, at most: 39 degrees.
const STEEPEST_SHOULDER: f64 = 0.8;
/// A neckline falls at least this far from the shoulder [m].
const LEAST_NECK_DEPTH: f64 = 0.2 * CM;
/// A neckline ends above the bust line over the waist, at least this share of it.
const LOWEST_NECK: f64 = 0.9;

/// A measure that does not go with the others.
pub(crate) fn unfit(
    measure: Measure,
    measures: &Measures,
    [least, most]: [f64; 2],
    remedy: lole_language::Words,
) -> DraftError {
    // Told in millimeters: what is refused does not stand inside.
    DraftError::Measure {
        what: measure.words(),
        cm: measure.of(measures).to_cm(),
        least_cm: (10.0 * least / CM).ceil() / 10.0,
        most_cm: (10.0 * most / CM).floor() / 10.0,
        remedy,
    }
}

/// Nothing else to do than to measure again.
pub(crate) const NO_REMEDY: lole_language::Words = words("", "");

#[derive(Debug, Clone, Copy)]
enum Side {
    Front,
    Back,
}

/// Widths of the block [m].
#[derive(Debug, Clone, Copy)]
struct Widths {
    neck: f64,
    back: f64,
    chest: f64,
    armhole: f64,
    shoulder: f64,
    drop: f64,
    /// Shoulder points lower than measured.
    lowered: f64,
    /// What the neckline takes of the shoulder.
    widened: f64,
    /// Wider front over a full bust.
    full_bust: f64,
}

impl Widths {
    fn new(measures: &Measures, fit: &Fit) -> Result<Self, DraftError> {
        let ease = 0.5 * fit.bust_ease;
        let broad = 0.5 * fit.alterations.of(Alteration::BroadBack).to_m();
        let back = 0.5 * measures.back_breadth.to_m() + EASE_OF_BACK * ease + broad;
        let chest = 0.5 * measures.chest_breadth.to_m() + EASE_OF_CHEST * ease;
        let half = 0.5 * measures.bust_girth.to_m() + ease + broad;
        let armhole = half - back - chest;
        let arm = measures.upper_arm_girth.to_m();
        // An arm is a third as thick as its girth, and its eye somewhat wider.
        let narrowest = 0.28 * arm;
        let thick = measures.bust_girth.to_m() * THICKEST_ARM;
        if armhole < narrowest && thick < arm {
            let band = [Measure::UpperArmGirth.band_cm()[0] * CM, armhole / 0.28];
            return Err(unfit(Measure::UpperArmGirth, measures, band, NO_REMEDY));
        }
        if armhole < narrowest {
            let bust = 2.0 * (narrowest + back + chest - ease);
            return Err(unfit(
                Measure::BustGirth,
                measures,
                [bust, Measure::BustGirth.band_cm()[1] * CM],
                words(
                    "。または胸のゆとりを増やしてください",
                    ", or give the bust more ease",
                ),
            ));
        }
        let neck = 0.2 * measures.neck_girth.to_m() - 0.2 * CM;
        let shoulder = 0.5 * measures.shoulder_breadth.to_m();
        Ok(Self {
            neck,
            back,
            chest,
            armhole,
            shoulder,
            drop: measures.shoulder_drop.to_m(),
            lowered: fit.alterations.of(Alteration::SlopingShoulders).to_m(),
            widened: fit.neck_widened,
            full_bust: fit.alterations.of(Alteration::FullBust).to_m(),
        })
    }

    /// From the shoulder point to the side of the neck. The back one is longer by its ease.
    fn shoulder_line(&self, lengths: &Lengths, side: Side) -> [Point; 2] {
        let run = self.shoulder - self.neck;
        let front_reach = Vec2::new(run, -1.1 * self.drop - self.lowered);
        match side {
            Side::Front => {
                let neck = at(self.neck, lengths.front_neck);
                [neck + front_reach, neck]
            }
            Side::Back => {
                let width = self.neck + 0.2 * CM;
                let neck = at(width, lengths.nape + 0.5 * lengths.rounded + width / 3.0);
                let drop = 0.9 * self.drop + self.lowered + 0.5 * lengths.rounded;
                let reach = Vec2::new(run, -drop);
                let sewn = (front_reach.hypot() - self.widened).max(0.0);
                let ease = SHOULDER_EASE.min(SHARE_OF_SHOULDER * sewn);
                let long = front_reach.hypot() + ease;
                [neck + reach * (long / reach.hypot().max(1.0e-6)), neck]
            }
        }
    }
}

/// Heights over the waist [m].
#[derive(Debug, Clone, Copy)]
struct Lengths {
    nape: f64,
    /// Nape higher over round shoulder blades, and half of it the neck's side; the shoulder point stays.
    rounded: f64,
    front_neck: f64,
    bust_line: f64,
    bust_point: f64,
}

impl Lengths {
    /// These, of a back that is not altered.
    const fn of_upright_back(self) -> Self {
        Self {
            rounded: 0.0,
            ..self
        }
    }

    fn new(measures: &Measures, fit: &Fit, widths: &Widths) -> Result<Self, DraftError> {
        let nape = measures.back_length.to_m();
        let bust = measures.bust_girth.to_m();
        let by = |alteration| fit.alterations.of(alteration).to_m();
        let depth = (bust / 12.0 + 13.7 * CM).min(DEEPEST_ARMHOLE * nape)
            + fit.armhole_dropped
            + by(Alteration::SlopingShoulders);
        let bust_line = nape - depth;
        let front_neck = measures.front_length.to_m() - ASLANT;
        // Both shoulders hang on the same arm: a front that is much shorter or longer than the back was
        // measured wrong.
        let back_neck = nape + (widths.neck + 0.2 * CM) / 3.0;
        let [least, most] = [back_neck - 5.5 * CM, back_neck + 0.16 * bust];
        if !(least..=most).contains(&front_neck) {
            let lengths = [least + ASLANT, most + ASLANT];
            return Err(unfit(Measure::FrontLength, measures, lengths, NO_REMEDY));
        }
        let over_waist = (measures.bust_height - measures.waist_height).to_m();
        if bust_line < 3.0 * CM || over_waist < 2.0 * CM {
            let least = 3.0 * CM + depth;
            let band = [least, Measure::BackLength.band_cm()[1] * CM];
            return Err(unfit(Measure::BackLength, measures, band, NO_REMEDY));
        }
        Ok(Self {
            nape,
            rounded: by(Alteration::RoundBack),
            front_neck: front_neck + by(Alteration::FullBust),
            bust_line,
            bust_point: over_waist.clamp(0.6 * bust_line, bust_line),
        })
    }
}

/// The angle by which the front's underarm is raised about the bust point.
fn dart_angle(
    measures: &Measures,
    (underarm, bust_point): (Point, Point),
    [back_tip, front_tip]: [f64; 2],
    bust_line: f64,
) -> Result<f64, DraftError> {
    let bust = measures.bust_girth.to_m();
    let cup = (bust - measures.underbust_girth.to_m()) / (FULL_CUP * bust);
    let shallower = SHALLOWER_FRONT * cup.clamp(0.0, 1.0) * (back_tip - bust_line);
    let rise = front_tip - back_tip + shallower;
    if rise < LEAST_RISE {
        return Ok(0.0);
    }
    let arm = underarm - bust_point;
    // The underarm turns on a circle about the bust point until it is `rise` higher.
    let start = trig64::atan2(arm.y, arm.x);
    let widest = trig64::sin((start + WIDEST_DART).min(std::f64::consts::FRAC_PI_2));
    let reach = (arm.y + rise) / arm.hypot().max(1.0e-6);
    let over = rise - (widest * arm.hypot() - arm.y);
    if arm.x < 1.0 * CM || LONGER_FRONT < over {
        let length = measures.front_length.to_m() - (over - LONGER_FRONT).max(0.0);
        let band = [Measure::FrontLength.band_cm()[0] * CM, length];
        return Err(unfit(Measure::FrontLength, measures, band, NO_REMEDY));
    }
    Ok((trig64::asin(reach.min(widest)) - start).max(0.0))
}

impl Half {
    /// `turned` is the angle of the armhole's lower end to the level.
    fn new(
        underarm: Point,
        turned: f64,
        narrow: f64,
        [tip, neck]: [Point; 2],
        (center, widened): (Point, f64),
    ) -> Self {
        let (armhole, narrowest) = armhole(underarm, turned, narrow, [tip, neck]);
        let along = (tip - neck) / (tip - neck).hypot().max(1.0e-9);
        let neck = neck + along * widened;
        Self {
            underarm,
            armhole,
            narrowest,
            shoulder: [tip, neck],
            neckline: neckline(neck, along, center),
            center,
        }
    }
}

/// From the underarm, level there, up to the shoulder point, square to the shoulder there.
fn armhole(
    underarm: Point,
    turned: f64,
    narrow: f64,
    [tip, neck]: [Point; 2],
) -> (Vec<PathSeg>, Point) {
    /// Height of the narrowest place within the armhole, and handles as shares of the way.
    const NARROWEST: f64 = 0.42;
    const LEVEL: f64 = 0.66;
    const UPRIGHT: f64 = 0.58;
    const UP: f64 = 0.42;
    const SQUARE: f64 = 0.30;
    let height = tip.y - underarm.y;
    // The armhole never bulges beyond the shoulder point or the underarm.
    let x = narrow.min(tip.x - 0.2 * CM).min(underarm.x - 1.0 * CM);
    let narrowest = at(x, underarm.y + NARROWEST * height);
    let (sin, cos) = trig64::sin_cos(turned);
    let level = Vec2::new(-cos, -sin) * (LEVEL * (underarm.x - x));
    let upright = Vec2::new(0.0, UPRIGHT * NARROWEST * height);
    let along = (tip - neck) / (tip - neck).hypot().max(1.0e-9);
    let square = Vec2::new(-along.y, along.x) * (SQUARE * height * (1.0 - NARROWEST));
    let up = Vec2::new(0.0, UP * height * (1.0 - NARROWEST));
    let lower = curve(underarm, level, upright, narrowest);
    let upper = curve(narrowest, up, square, tip);
    (vec![lower, upper], narrowest)
}

/// From the shoulder, square to it, to the center, level there.
fn neckline(neck: Point, along: Vec2, center: Point) -> Vec<PathSeg> {
    let drop = neck.y - center.y;
    let square = Vec2::new(along.y, -along.x) * (0.55 * drop);
    // A shallow back neckline runs level for longer.
    let flat = if drop < neck.x * 0.6 { 0.65 } else { 0.58 };
    let level = Vec2::new(-flat * neck.x, 0.0);
    vec![curve(neck, square, level, center)]
}

/// A dart at the side, from the side seam towards the bust point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SideDart {
    /// On the side seam: the lower leg's end, then the upper one's.
    pub(crate) legs: [Point; 2],
    /// Where both end, short of the bust point.
    pub(crate) apex: Point,
    /// Point of the seam line between the legs that meets the seam when the dart is pressed down.
    pub(crate) roof: Point,
}

/// How far a dart ends from the bust point [m].
const SHORT_OF_BUST_POINT: f64 = 2.5 * CM;

impl Block {
    /// The dart whose lower leg ends at `lower` on the front's side seam, of which `down` is the way
    /// downwards; `None` where the front is not pivoted enough to need one.
    pub(crate) fn side_dart(&self, lower: Point, down: Vec2) -> Option<SideDart> {
        if self.dart_angle <= 0.0 {
            return None;
        }
        let pivot = Affine::rotate_about(self.dart_angle, self.bust_point);
        let upper = pivot * lower;
        let half = Affine::rotate_about(0.5 * self.dart_angle, self.bust_point) * lower;
        let towards = (half - self.bust_point) / (half - self.bust_point).hypot().max(1.0e-9);
        let apex = self.bust_point
            + towards * SHORT_OF_BUST_POINT.min(0.4 * (half - self.bust_point).hypot());
        // Pressed down, the dart's fold lies as far below the lower leg as above it: there it must meet
        // the seam.
        let leg = lower - apex;
        let fold = half - apex;
        let angle = trig64::atan2(leg.cross(fold), leg.dot(fold));
        let folded = Affine::rotate(-angle) * Point::new(leg.x, leg.y);
        let ray = folded.to_vec2() / folded.to_vec2().hypot().max(1.0e-9);
        let cross = ray.cross(down);
        let reach = if cross.abs() < 1.0e-6 {
            fold.hypot()
        } else {
            (lower - apex).cross(down) / cross
        };
        let reach = reach.clamp(0.9 * leg.hypot(), 1.15 * leg.hypot());
        Some(SideDart {
            legs: [lower, upper],
            apex,
            roof: apex + fold * (reach / fold.hypot().max(1.0e-9)),
        })
    }
}
