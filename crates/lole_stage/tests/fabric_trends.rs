//! Fabrics of the shelf drape in the order in which dressmakers know them.

use glam::Vec3;
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Grid, MassLaw, SolverConfig, StepInput, Topology, step,
};
use lole_costume::fabrics::Preset;

/// Particles along a side of a square of 30 cm, and their distance [m].
const COUNT: u32 = 31;
const SPACING: f32 = 0.01;
/// Radius of the disc that it hangs from [m].
const DISC: f32 = 0.09;

/// Share of the square's overhang that is still seen from above when it hangs from a disc.
fn drape_coefficient(preset: &str) -> f32 {
    let grid = Grid {
        column_count: COUNT,
        row_count: COUNT,
        topology: Topology::Sheet,
        spacing: [SPACING; 2],
        flounce: None,
        crimp: None,
    };
    let half = 0.5 * SPACING * (COUNT - 1) as f32;
    let place = |row: u32, column: u32| {
        let [x, z] = [column, row].map(|index| index as f32 * SPACING - half);
        // Uneven as no symmetry of the square is.
        Vec3::new(x, 2.0e-4 * lole_geom::trig::sin(47.0 * x + 31.0 * z), z)
    };
    let start: Vec<Vec3> = (0..COUNT)
        .flat_map(|row| (0..COUNT).map(move |column| place(row, column)))
        .collect();
    let flat = |place: &Vec3| place.x * place.x + place.z * place.z;
    let mut fabric = Preset::from_id(preset).expect("on the shelf").fabric();
    // In thick air it comes to rest sooner, and no other.
    fabric.drag_rate = 6.0;
    let spec = ClothSpec {
        fabric,
        row_layers: vec![1.0; COUNT as usize],
        mass: MassLaw::AreaWeighted,
        pinned: start
            .iter()
            .map(|place| flat(place) < DISC * DISC)
            .collect(),
        grid,
    };
    let model = ClothModel::new(&spec).expect("a sound cloth");
    let pins: Vec<Vec3> = (model.pin_indices().iter())
        .map(|&pin| start[pin as usize])
        .collect();
    let mut state = ClothState::new(&model, &start);
    let config = SolverConfig {
        column_strides: Vec::new(),
        tether_scale: None,
        ..SolverConfig::default()
    };
    for _ in 0..180 {
        let input = StepInput {
            pin_targets: &pins,
            capsules: &[],
            ..StepInput::default()
        };
        step(&model, &config, &input, &mut state, 1.0 / 60.0).expect("a target for every pin");
    }
    let mut positions = Vec::new();
    state.copy_positions(&model, &mut positions);
    // The hem's mean reach, squared, over that of the flat square.
    let on_rim = |particle: &usize| {
        let (row, column) = (particle / COUNT as usize, particle % COUNT as usize);
        [row, column]
            .iter()
            .any(|&i| i == 0 || i + 1 == COUNT as usize)
    };
    let beyond = |places: &[Vec3]| -> f32 {
        (0..places.len())
            .filter(on_rim)
            .map(|particle| flat(&places[particle]) - DISC * DISC)
            .sum()
    };
    beyond(&positions) / beyond(&start)
}

#[test]
fn rayon_and_satin_drape_more_than_broadcloth_and_barkcloth_least() {
    let [rayon, satin, broadcloth, print, barkcloth] = [
        "rayon-challis",
        "polyester-satin",
        "polycotton-broadcloth",
        "polyester-print",
        "barkcloth",
    ]
    .map(drape_coefficient);
    let found = [rayon, satin, broadcloth, print, barkcloth];
    assert!(rayon < broadcloth && satin < broadcloth, "{found:?}");
    assert!(broadcloth < print && print < barkcloth, "{found:?}");
    // All of them bend, none of them hangs straight down.
    assert!(
        found.iter().all(|share| (0.02..0.98).contains(share)),
        "{found:?}"
    );
}
