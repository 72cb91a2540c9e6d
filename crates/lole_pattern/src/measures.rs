//! What a tape says about a body, as far as drafting asks.

use lole_geom::Length;

/// Measures of one body. All are given or estimated by whoever made them: a draft does not guess.
#[derive(Debug, Clone, PartialEq)]
pub struct Measures {
    /// Height without shoes.
    pub stature: Length,
    /// Fullest girth of the bust.
    pub bust_girth: Length,
    /// Girth right below the bust.
    pub underbust_girth: Length,
    /// Girth of the waist.
    pub waist_girth: Length,
    /// Fullest girth of the hips.
    pub hip_girth: Length,
    /// Girth around the root of the neck.
    pub neck_girth: Length,
    /// Girth around the head above the brows.
    pub head_girth: Length,
    /// Girth of the upper arm below the armpit.
    pub upper_arm_girth: Length,
    /// Girth of the wrist.
    pub wrist_girth: Length,
    /// Girth of the ankle.
    pub ankle_girth: Length,
    /// Girth through the crotch: waist in front, between the legs, waist at the back.
    pub crotch_length: Length,
    /// From the point of one shoulder to the other.
    pub shoulder_breadth: Length,
    /// From the shoulder point to the elbow.
    pub upper_arm_length: Length,
    /// From the shoulder point to the wrist along the arm.
    pub arm_length: Length,
    /// From the bone at the nape down to the waist.
    pub back_length: Length,
    /// From the side of the neck over the bust point to the waist.
    pub front_length: Length,
    /// How far the shoulder falls from the side of the neck to its point.
    pub shoulder_drop: Length,
    /// Across the back between the arms.
    pub back_breadth: Length,
    /// Across the chest between the arms.
    pub chest_breadth: Length,
    /// Between the two bust points.
    pub bust_point_breadth: Length,
    /// Height of the side of the neck above the floor.
    pub neck_height: Length,
    /// Height of the fullest bust above the floor.
    pub bust_height: Length,
    /// Height of the armpit above the floor.
    pub armpit_height: Length,
    /// Height of the waist above the floor.
    pub waist_height: Length,
    /// Height of the fullest hips above the floor.
    pub hip_height: Length,
    /// Height of the knee above the floor.
    pub knee_height: Length,
    /// Girth of the trunk by height above the floor, from the crotch up to the armpits, rising.
    pub trunk: Vec<TrunkGirth>,
}

/// A tape around the trunk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrunkGirth {
    /// Above the floor.
    pub height: Length,
    /// Of the taut tape.
    pub girth: Length,
}

impl Measures {
    /// Girth of the trunk at a height above the floor, between two tapes in proportion; the nearest
    /// tape's beyond the ends, `None` without tapes.
    #[must_use]
    pub fn girth_at(&self, height: Length) -> Option<Length> {
        let above = self.trunk.partition_point(|tape| tape.height < height);
        let (Some(below), Some(above)) = (
            self.trunk.get(above.saturating_sub(1)),
            self.trunk.get(above).or(self.trunk.last()),
        ) else {
            return None;
        };
        let rise = (above.height - below.height).to_m();
        let part = if rise <= 0.0 {
            0.0
        } else {
            ((height - below.height).to_m() / rise).clamp(0.0, 1.0)
        };
        Some(below.girth + (above.girth - below.girth) * part)
    }
}
