//! Laws of what is cut, laid and sewn.

use lole_body::{Measurements, Tape};
use lole_cloth::Hysteresis;
use lole_geom::TriangleGrid;

use lole_language::Bilingual;
use lole_pattern::piece::Piece;
use lole_pattern::polygon::Polygon;

use super::*;
use crate::{Colors, Options, TEMPLATES, Template};

/// Surfels of the skin lie about this far apart [m].
const SPACING: f32 = 0.016;

/// A blend of polyester and cotton.
const BROADCLOTH: Fabric = Fabric {
    areal_density: 0.11,
    thickness: 0.22e-3,
    stretch: [4500.0, 2800.0],
    shear: 90.0,
    bend: [9.0e-6, 6.0e-6],
    twist: 7.35e-6,
    hysteresis: Hysteresis {
        bend: [0.945e-3, 0.63e-3],
        shear: 4.5,
    },
    friction: 0.45,
    cloth_friction: 0.45,
    drag_rate: 0.5,
};

fn woman() -> Dancer {
    Dancer::new(&Measurements::woman()).unwrap()
}

/// A garment with these options, of broadcloth.
const fn spec<'a>(template: &'static Template, options: &'a Options) -> GarmentSpec<'a> {
    GarmentSpec {
        template,
        options,
        fabric: BROADCLOTH,
        colors: Colors {
            ground: [0; 3],
            flower: [0; 3],
            leaf: [0; 3],
            shadow: [0; 3],
        },
        alterations: lole_pattern::Alterations::NONE,
        tailor_tape: lole_pattern::TailorTape::NONE,
        given: None,
    }
}

fn laid(template: &str, dancer: &Dancer) -> laid::Laid {
    let template = Template::of_id(template).unwrap();
    let Wear::Sewn(row) = &template.worn else {
        panic!("{} is not sewn", template.id);
    };
    let measures = crate::measures(dancer);
    let pattern = (template.draft)(&Fitting::by(&measures), &Options::of(template)).unwrap();
    let body = (dancer, &measures);
    laid::lay((template.id, row), pattern, body, (Division::Full, None)).unwrap()
}

fn put_on(template: &str, dancer: &Dancer) -> Dressed {
    put_on_among(template, dancer, &Among::default())
}

fn put_on_among(template: &str, dancer: &Dancer, among: &Among<'_>) -> Dressed {
    let triangles = dancer.skin.body_triangles();
    let surfels = MeshSurfels::new(&dancer.skin.positions, &triangles, SPACING);
    let template = Template::of_id(template).unwrap();
    let options = Options::of(template);
    let spec = spec(template, &options);
    dress(&spec, (dancer, &surfels), &Pose::default(), among).unwrap()
}

/// Every garment that is sewn on her.
fn all() -> impl Iterator<Item = &'static str> {
    let sewn = TEMPLATES.iter().filter(|it| it.is_sewn());
    sewn.map(|it| it.id)
}

/// Area of all triangles [m²], each as often as the mean of what `layers` says of its corners.
fn area_of_layers(laid: &laid::Laid, layers: impl Fn(usize) -> f32) -> f64 {
    let area = |corners: &[u32; 3]| {
        let corners = corners.map(|corner| corner as usize);
        let [a, b, c] = corners.map(|corner| laid.mesh.in_piece[corner]);
        let layers: f32 = corners.into_iter().map(&layers).sum();
        f64::from(layers) / 3.0 * 0.5 * (b - a).perp_dot(c - a)
    };
    laid.mesh.triangles.iter().map(area).sum()
}

/// Area of all pieces that are laid [m²], as often as each is cut, by what `outline` takes of it.
fn area_of_pieces(laid: &laid::Laid, outline: impl Fn(&Piece) -> Polygon) -> f64 {
    let pieces = laid.pattern.pieces.iter();
    let pieces = pieces.filter(|piece| piece.id != "binding");
    let area = |piece: &Piece| {
        let area = outline(&piece.unfolded()).signed_area().abs();
        area * f64::from(piece.cut.pieces())
    };
    pieces.map(area).sum()
}

#[test]
fn triangles_cover_the_pieces_that_are_cut_but_for_darts() {
    let dancer = woman();
    for template in all() {
        let laid = laid(template, &dancer);
        let pieces = area_of_pieces(&laid, |piece| piece.stitching_polygon(1.0e-3));
        let share = area_of_layers(&laid, |_| 1.0) / pieces;
        assert!((0.97..1.003).contains(&share), "{template}: {share}");
    }
}

/// What is folded under at hems and seams weighs as much where it lies as it was cut.
#[test]
fn a_garment_weighs_as_much_as_the_cloth_that_is_cut() {
    let dancer = woman();
    for template in all() {
        let laid = laid(template, &dancer);
        let cut = area_of_pieces(&laid, |piece| piece.cut_polygon(1.0e-3));
        let share = area_of_layers(&laid, |corner| laid.layers[corner]) / cut;
        assert!((0.96..1.04).contains(&share), "{template}: {share}");
    }
}

#[test]
fn every_particle_is_laid_outside_of_the_skin_at_a_place() {
    let dancer = woman();
    for template in all() {
        let laid = laid(template, &dancer);
        assert_eq!(laid.places.len(), laid.mesh.flat.len());
        assert!(
            laid.places.iter().all(|place| place.is_finite()),
            "{template}"
        );
        let form = Form::new(&dancer, &fit::fitting_pose(), 0.12);
        let mut pushed = laid.places.clone();
        form.push_out(&mut pushed, |_| 0.002);
        let moved = pushed
            .iter()
            .zip(&laid.places)
            .filter(|(a, b)| 1.0e-4 < a.distance(**b));
        let share = moved.count() as f32 / pushed.len() as f32;
        assert!(share < 0.01, "{template}: {share}");
    }
}

#[test]
fn both_sides_of_a_gathered_seam_are_sewn_from_end_to_end() {
    let dancer = woman();
    let laid = laid("muumuu", &dancer);
    // The ruffle is one and a half times as long as the hem: two of its points to one of the hem's.
    let ruffle = laid
        .pattern
        .pieces
        .iter()
        .position(|piece| piece.id == "ruffle")
        .unwrap();
    let is_ruffle = |particle: u32| {
        let panel = laid.mesh.panel_of[particle as usize];
        panel + 2 >= laid.is_on_arm.len() && 0 < ruffle
    };
    let puckers = laid
        .mesh
        .puckers
        .iter()
        .filter(|pucker| is_ruffle(pucker.0))
        .count();
    assert!(40 < puckers, "{puckers}");
}

#[test]
fn what_is_sewn_stays_sewn_and_the_same_dressing_gives_the_same_bits() {
    let dancer = woman();
    let blouse = put_on("blouse", &dancer);
    let again = put_on("blouse", &dancer);
    assert_eq!(blouse.state().hash(), again.state().hash());
    let sewn = blouse.welded.iter().enumerate();
    let sewn = sewn.filter(|(particle, group)| **group as usize != *particle);
    let mut apart: Vec<f32> = sewn
        .map(|(particle, &group)| blouse.start[particle].distance(blouse.start[group as usize]))
        .collect();
    apart.sort_by(f32::total_cmp);
    let count = apart.len();
    assert!(150 < count, "{count}");
    // Where folds press on a seam from both sides it gives a little; it is drawn closed.
    let [nearly_all, most] = [apart[count * 19 / 20], apart[count - 1]];
    assert!(
        nearly_all < 0.004 && most < 0.02,
        "{nearly_all} and {most} m"
    );
    // It hangs on the shoulders: no lower than its hem was drafted, no higher than the neck.
    let heights = blouse.start.iter().map(|place| place.y);
    let [low, high] = heights.fold([9.0_f32, 0.0], |[low, high], y| [low.min(y), high.max(y)]);
    let waist = dancer.landmarks.waist_height;
    assert!((waist - 0.24..waist - 0.08).contains(&low), "{low}");
    assert!(waist + 0.3 < high, "{high}");
}

#[test]
fn what_is_below_a_band_lies_thin_on_the_skin_and_all_else_is_free() {
    let dancer = woman();
    let edge: Vec<Vec3> = dancer
        .tape_ring(dancer.landmarks.waist_height, 64)
        .iter()
        .map(|point| point.bind_position)
        .collect();
    let among = Among {
        bands: Some(Bands { edge: &edge }),
        ..Among::default()
    };
    let blouse = put_on_among("blouse", &dancer, &among);
    let model = blouse.model().unwrap();
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    let world_from_bind = dancer.skeleton.world_from_bind(&Pose::default());
    (dancer.skin).pose(&world_from_bind, &mut positions, &mut normals);
    let triangles = dancer.skin.body_triangles();
    let skin = TriangleGrid::new(&positions, &triangles, 0.03);
    let pinned = &model.spec().pinned;
    let tucked = pinned.iter().filter(|pinned| **pinned).count();
    assert!(
        500 < tucked && tucked < blouse.particle_count() / 2,
        "{tucked}"
    );
    for (place, pinned) in blouse.start.iter().zip(pinned) {
        let below = dancer.landmarks.waist_height - place.y;
        if *pinned {
            let nearest = skin.nearest(*place, 0.05).unwrap();
            assert!(nearest.distance < 0.004, "{} m", nearest.distance);
            assert!(-0.04 < below, "{below}");
        } else {
            assert!(below < 0.01, "{below} m below the edge and free");
        }
    }
    // Nothing of it is in the way of the skirt.
    assert!(blouse.hanging_triangles.is_empty());
    assert!(blouse.open_triangles.len() < blouse.triangles.len() - tucked);
}

/// Dancers whom nothing was laid for: a short round one and a tall slight one.
fn others() -> [Dancer; 2] {
    [[148.0, 98.0, 86.0, 104.0], [176.0, 84.0, 66.0, 93.0]].map(|tape| {
        let [stature, bust_girth, waist_girth, hip_girth] =
            tape.map(|cm| Some(lole_geom::Length::from_cm(cm)));
        let tape = Tape {
            stature,
            bust_girth,
            waist_girth,
            hip_girth,
            ..Tape::default()
        };
        Dancer::new(&Measurements::from_tape(&tape).unwrap()).unwrap()
    })
}

#[test]
fn no_fold_of_one_cloth_goes_through_another() {
    for template in all() {
        let garment = put_on(template, &woman());
        assert_eq!(garment.crossings(&garment.start), Some(0), "{template}");
    }
    // Under the arm of some a kīkepa finds no room for its edge.
    for dancer in &others() {
        for template in all().filter(|template| *template != "kikepa") {
            let garment = put_on(template, dancer);
            assert_eq!(garment.crossings(&garment.start), Some(0), "{template}");
        }
    }
    // Cloth turned about itself does: the law can fail.
    let kihei = put_on("kihei", &woman());
    let turned = kihei.start.iter().enumerate().map(|(particle, place)| {
        let inside_out = if particle % 2 == 0 { -0.02 } else { 0.02 };
        *place + Vec3::Z * inside_out
    });
    let turned: Vec<Vec3> = turned.collect();
    assert!(Some(0) < kihei.crossings(&turned));
}

#[test]
fn what_is_gathered_touches_its_seam_and_is_through_it_where_it_is_drawn_through() {
    let dress = put_on("muumuu", &woman());
    assert!(100 < dress.puckers.len());
    assert_eq!(dress.crossings(&dress.start), Some(0));
    // One point of the ruffle far from its seam, drawn out through the other side of the dress.
    let below = |particle: &usize| dress.piece_of(number(*particle)).1 == "ruffle";
    let ruffle = (0..dress.particle_count()).filter(below);
    let lowest = ruffle.min_by(|&a, &b| dress.start[a].y.total_cmp(&dress.start[b].y));
    let mut pulled = dress.start.clone();
    pulled[lowest.unwrap()] *= Vec3::new(-4.0, 5.0, -4.0);
    assert!(Some(0) < dress.crossings(&pulled));
}

#[test]
fn a_wrap_knows_its_turns_and_says_where_one_has_gone_inside() {
    let dancer = woman();
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    let world_from_bind = dancer.skeleton.world_from_bind(&Pose::default());
    (dancer.skin).pose(&world_from_bind, &mut positions, &mut normals);
    let body = Body {
        positions: &positions,
        normals: &normals,
        triangles: &dancer.skin.body_triangles(),
    };
    for template in ["malo", "kikepa"] {
        let garment = put_on(template, &dancer);
        let layers = Layers::new(&garment, &garment.start, body);
        let count = layers.places().len();
        assert!(500 < count, "{template}: {count}");
        assert_eq!(layers.inversions(&garment, &garment.start, body), 0);
        // What lies inside is brought out over what covers it.
        let mut turned = garment.start.clone();
        for place in layers.places() {
            let outer = place.outer.map(|corner| garment.start[corner as usize]);
            let way = outer.iter().sum::<Vec3>() / 3.0 - garment.start[place.inner as usize];
            turned[place.inner as usize] = garment.start[place.inner as usize] + 1.8 * way;
        }
        assert!(0 < layers.inversions(&garment, &turned, body), "{template}");
    }
}

/// A garment that is held at her waist, shoulders or hips stays there while she goes half a meter.
#[test]
fn every_garment_goes_where_she_goes() {
    let dancer = woman();
    let triangles = dancer.skin.body_triangles();
    const FRAMES: u16 = 24;
    let skin = MeshSurfels::new(&dancer.skin.positions, &triangles, SPACING);
    for template in all() {
        let garment = put_on(template, &dancer);
        let mut state = garment.state();
        for frame in 1..=FRAMES {
            let pose = Pose {
                hips_translation: Vec3::X * (0.5 * f32::from(frame) / f32::from(FRAMES)),
                ..Pose::default()
            };
            let world_from_bind = dancer.skeleton.world_from_bind(&pose);
            let (mut positions, mut normals, mut surfels) = (Vec::new(), Vec::new(), Vec::new());
            (dancer.skin).pose(&world_from_bind, &mut positions, &mut normals);
            skin.pose(&positions, &normals, &mut surfels);
            let world = World {
                skin: (&positions, &normals),
                surfels: &surfels,
                world_from_bind: &world_from_bind,
                air_velocity: Vec3::ZERO,
                floor: Vec3::ZERO,
                held: &[],
            };
            state.step(&garment, &world, 1.0 / 60.0).unwrap();
        }
        let mut now = Vec::new();
        state.copy_positions(&garment, &mut now);
        let middle =
            |places: &[Vec3]| places.iter().map(|p| p.x).sum::<f32>() / places.len() as f32;
        let way = middle(&now) - middle(&garment.start);
        assert!((0.35..0.6).contains(&way), "{template} went {way} m");
    }
}

#[test]
fn what_is_put_on_last_lies_outside() {
    let dancer = woman();
    let dress = put_on("muumuu", &dancer);
    let inside = [(&dress.trunk_triangles[..], &dress.start[..])];
    let among = Among {
        inside: &inside,
        ..Among::default()
    };
    let kihei = put_on_among("kihei", &dancer, &among);
    let stance = Pose::default();
    let mut under = Under::new(&dancer, &stance, &inside);
    under.add(&dancer.skeleton.world_from_bind(&stance), &mut Vec::new());
    let clearances = kihei
        .start
        .iter()
        .filter_map(|place| under.clearance(*place));
    let mut clearances: Vec<f32> = clearances.collect();
    clearances.sort_by(f32::total_cmp);
    let count = clearances.len();
    assert!(2000 < count, "{count}");
    let low = clearances[count / 50];
    assert!(-0.01 < low, "{low} m");
}

#[test]
fn what_is_not_sewn_is_refused_by_name() {
    let dancer = woman();
    let triangles = dancer.skin.body_triangles();
    let surfels = MeshSurfels::new(&dancer.skin.positions, &triangles, SPACING);
    for template in TEMPLATES.iter().filter(|it| !it.is_sewn()) {
        let options = Options::of(template);
        let body = (&dancer, &surfels);
        let refused = dress(
            &spec(template, &options),
            body,
            &Pose::default(),
            &Among::default(),
        );
        let error = refused.err().unwrap();
        assert!(error.to_string().contains(template.id), "{error}");
        assert!(error.japanese().contains(template.id), "{error}");
    }
}

/// Bits that every machine comes to: a blouse, sewn on her and worn for a moment.
#[test]
fn golden_hash_of_a_blouse() {
    let dancer = woman();
    let blouse = put_on("blouse", &dancer);
    let triangles = dancer.skin.body_triangles();
    let surfels = MeshSurfels::new(&dancer.skin.positions, &triangles, SPACING);
    let bones = dancer.skeleton.world_from_bind(&Pose::default());
    let (mut positions, mut normals, mut met) = (Vec::new(), Vec::new(), Vec::new());
    dancer.skin.pose(&bones, &mut positions, &mut normals);
    surfels.pose(&positions, &normals, &mut met);
    let world = World {
        skin: (&positions, &normals),
        surfels: &met,
        world_from_bind: &bones,
        air_velocity: Vec3::ZERO,
        floor: Vec3::ZERO,
        held: &[],
    };
    let mut state = blouse.state();
    let mut text = String::new();
    for frame in [0, 4] {
        for _ in 0..frame {
            state.step(&blouse, &world, 1.0 / 60.0).unwrap();
        }
        text += &format!("blouse after {frame} frames {:016x}\n", state.hash());
    }
    lole_golden::check("state_hashes.txt", &text);
}
