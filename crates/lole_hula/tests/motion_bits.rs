//! The first four steps keep their bits: films and hashes of designs rest on them.

mod motion_support;

use lole_hula::{AmiTurn, ArmStyle, Dance, DanceStep, HipLead, HipLift, MotionSettings};
use motion_support::woman;

/// FNV-1a over the bits of every number of the poses in the lead-in and two loops; a zero counts
/// the same with either sign.
fn pose_hash(settings: &MotionSettings) -> u64 {
    let dance = Dance::new(&woman(), settings).expect("settings within their ranges");
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut add = |value: f32| {
        for byte in (value + 0.0).to_bits().to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for frame in 0..600_u16 {
        let pose = dance.pose_at(f32::from(frame) / 37.0);
        pose.hips_translation
            .to_array()
            .into_iter()
            .for_each(&mut add);
        for rotation in &pose.rotations {
            rotation.to_array().into_iter().for_each(&mut add);
        }
    }
    hash
}

#[test]
fn the_first_four_steps_keep_their_bits() {
    let of = |dance_step| MotionSettings {
        dance_step,
        ..MotionSettings::default()
    };
    let school = |dance_step| MotionSettings {
        hip_lift: HipLift::FreeSide,
        hip_lead: HipLead::SteppingFoot,
        ami_turn: AmiTurn::Hema,
        arms: ArmStyle::Open,
        beats_per_minute: 113.0,
        sway: 1.3,
        knee_degrees: 41.0,
        step_width: 0.21,
        ..of(dance_step)
    };
    let golden: [(DanceStep, u64, u64); 4] = [
        (DanceStep::Kao, 0x71a2_53ca_ca3f_b13d, 0xf4ba_9eae_3600_dca4),
        (
            DanceStep::Kaholo,
            0xdd4c_4693_7a0e_dc93,
            0x3315_c3c1_76aa_1227,
        ),
        (DanceStep::Ami, 0x6f46_9c20_d3e3_8900, 0x514f_9e7f_2d5c_ddb2),
        (
            DanceStep::Uwehe,
            0x26f5_d362_9e23_bc80,
            0x500f_8467_c8aa_d0f0,
        ),
    ];
    for (step, plain, other) in golden {
        assert_eq!(pose_hash(&of(step)), plain, "{step:?}");
        assert_eq!(
            pose_hash(&school(step)),
            other,
            "{step:?} in another manner"
        );
    }
}
