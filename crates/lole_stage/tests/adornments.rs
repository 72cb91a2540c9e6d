//! What is worn beside the cloth stays where it is worn.

use glam::Vec3;
use lole_costume::document::{self, Design};
use lole_geom::TriangleGrid;
use lole_stage::{FRAMES_PER_SECOND, Performance, Production};

/// Seconds that are danced.
const SECONDS: u32 = 3;
/// Deepest that the middle of a strand may be in the skin [m]: what legs pinch has no room.
const DEEPEST: f32 = 0.008;

fn design(text: &str) -> Design {
    document::parse(&format!("lole = 1\n{text}"), "test").expect("a design")
}

fn on_stage(text: &str) -> Performance {
    Performance::new(Production::new(&design(text)).expect("can be made")).expect("can be worn")
}

const DANCERS: &[&str] = &[
    "[dancer]\nfigure = \"child\"\nstature_cm = 120\n",
    "[dancer]\nfigure = \"woman\"\n",
    "[dancer]\nfigure = \"man\"\nstature_cm = 182\nhip_cm = 112\nwaist_cm = 104\n",
];

/// How deep a place is inside the skin [m]; negative outside, and far from it.
fn depth(
    place: Vec3,
    grid: &TriangleGrid<'_>,
    (normals, triangles): (&[Vec3], &[[u32; 3]]),
) -> f32 {
    assert!(place.is_finite());
    grid.nearest(place, 0.05).map_or(-1.0, |nearest| {
        let corners = triangles[nearest.triangle as usize];
        let normal: Vec3 = (corners.iter())
            .map(|&corner| normals[corner as usize])
            .sum();
        -(place - nearest.point).dot(normal.normalize_or_zero())
    })
}

/// Dances, and the deepest that a free particle of strands came into the skin [m], with the longest
/// stretch of a strand's spacing over what it should be.
fn worst(performance: &mut Performance, look_every: u32) -> (f32, f32) {
    let spacings: Vec<Vec<(usize, f32)>> = (performance.production().adornments.iter())
        .filter_map(|adornment| adornment.strands.as_ref())
        .map(|hung| {
            let strands = hung.strands.iter();
            strands
                .map(|one| (one.positions.len(), one.spacing))
                .collect()
        })
        .collect();
    let (mut deepest, mut longest) = (0.0_f32, 0.0_f32);
    for frame in 0..SECONDS * FRAMES_PER_SECOND {
        performance.advance().expect("it stays on stage");
        if frame % look_every != 0 {
            continue;
        }
        performance.pose_body();
        let triangles = &performance.production().body_triangles[..];
        let grid = TriangleGrid::new(performance.body_positions(), triangles, 0.03);
        let body = (performance.body_normals(), triangles);
        for (positions, strands) in performance.strand_positions().zip(&spacings) {
            let mut first = 0;
            for &(count, spacing) in strands {
                let strand = &positions[first..first + count];
                first += count;
                for pair in strand.windows(2) {
                    longest = longest.max(pair[0].distance(pair[1]) / spacing);
                }
                let depths = strand[2..].iter().map(|&place| depth(place, &grid, body));
                deepest = depths.fold(deepest, f32::max);
            }
        }
    }
    (deepest, longest)
}

#[test]
fn skirts_of_strands_stay_outside_the_skin_and_keep_their_length() {
    let kinds = ["ti-leaf-skirt", "raffia-skirt", "cellophane-skirt"];
    for (dancer, step) in DANCERS.iter().zip(["kaholo", "ami", "kaholo"]) {
        for kind in kinds {
            let mut performance = on_stage(&format!(
                "[skirt]\nworn = \"no\"\n[motion]\nstep = \"{step}\"\n{dancer}[[garment]]\nkind = \"{kind}\"\n"
            ));
            let (deepest, longest) = worst(&mut performance, 10);
            assert!(deepest < DEEPEST, "{kind}, {dancer}: {deepest} m");
            assert!(longest < 1.05, "{kind}, {dancer}: {longest}");
        }
    }
}

#[test]
fn a_skirt_of_strands_is_not_worn_around_the_legs() {
    for kind in ["ti-leaf-skirt", "raffia-skirt", "cellophane-skirt"] {
        for (worn_cm, is_refused) in [(40, true), (60, true), (85, false)] {
            let design = design(&format!(
                "[skirt]\nworn = \"no\"\n[[garment]]\nkind = \"{kind}\"\nworn_height_cm = {worn_cm}\nhem_height_cm = 10\n"
            ));
            let made = Production::new(&design).map(|_| ());
            let said = made.as_ref().err().map(ToString::to_string);
            assert_eq!(
                said.is_some(),
                is_refused,
                "{kind} at {worn_cm} cm: {said:?}"
            );
            let names_the_key = said.is_none_or(|it| it.contains("worn_height_cm"));
            assert!(names_the_key, "{kind} at {worn_cm} cm");
        }
    }
}

#[test]
fn lei_stay_around_the_neck_and_outside_the_skin() {
    for (dancer, step) in DANCERS.iter().zip(["ami", "kaholo", "kaholo"]) {
        for form in ["closed", "open"] {
            let mut performance = on_stage(&format!(
                "[skirt]\nworn = \"no\"\n[motion]\nstep = \"{step}\"\n{dancer}[[garment]]\nkind = \"lei\"\nform = \"{form}\"\n"
            ));
            let (deepest, longest) = worst(&mut performance, 10);
            assert!(deepest < DEEPEST, "{form}, {dancer}: {deepest} m");
            assert!(longest < 1.05, "{form}, {dancer}: {longest}");
            let production = performance.production();
            let hung = production.adornments[0].strands.as_ref().expect("a strand");
            let positions = performance.strand_positions().next().expect("a strand");
            for (tie, rider) in hung.ties.iter().zip(&hung.tie_riders) {
                let place = rider.posed(performance.world_from_bind())[0];
                let apart = positions[tie.particle as usize].distance(place);
                assert!(
                    apart < 0.05,
                    "{form}, {dancer}: {apart} m from its shoulder"
                );
            }
        }
    }
}

/// How far the lowest of a closed lei hangs below its ties as she stands [m], and the farthest that a
/// particle moves in a frame then [m].
fn lei_at_rest(worn: &str) -> (f32, f32) {
    let mut performance = on_stage(&format!(
        "[skirt]\nworn = \"no\"\n[motion]\nstep = \"hela\"\n{worn}[[garment]]\nkind = \"lei\"\n"
    ));
    let before: Vec<Vec3> = performance.strand_positions().flatten().copied().collect();
    performance.advance().expect("it stays on stage");
    let after: Vec<Vec3> = performance.strand_positions().flatten().copied().collect();
    let moved = before.iter().zip(&after).map(|(a, b)| a.distance(*b));
    let heights = || after.iter().map(|place| place.y);
    let [low, high] = [heights().fold(9.0, f32::min), heights().fold(0.0, f32::max)];
    (high - low, moved.fold(0.0, f32::max))
}

#[test]
fn a_lei_lies_over_a_blouse_as_it_lies_on_the_skin() {
    let (bare, _) = lei_at_rest("");
    let (over, moved) = lei_at_rest("[[garment]]\nkind = \"blouse\"\n");
    assert!((over - bare).abs() < 0.03, "{over} m for {bare} m");
    assert!(moved < 0.001, "{moved} m in a frame");
}

#[test]
fn what_bones_carry_touches_the_body_where_it_is_worn() {
    let mut performance = on_stage(
        "[skirt]\nworn = \"no\"\n[[garment]]\nkind = \"lei-poo\"\n[[garment]]\nkind = \"kupee\"\n[[garment]]\nkind = \"hair-flower\"\n[[garment]]\nkind = \"uliuli\"\n[[garment]]\nkind = \"puili\"\n[[garment]]\nkind = \"ipu\"\n",
    );
    performance.advance().expect("it stays on stage");
    performance.pose_body();
    let body = performance.body_positions();
    let production = performance.production();
    let mut posed = performance.surfaces().into_iter();
    for worn in production.worn() {
        let vertices: Vec<Vec3> = (worn.surfaces())
            .filter_map(|_| posed.next())
            .flat_map(|[positions, _]| positions)
            .collect();
        let gap = vertices.iter().map(|vertex| {
            let apart = body.iter().map(|place| place.distance_squared(*vertex));
            apart.fold(f32::INFINITY, f32::min)
        });
        let gap = gap.fold(f32::INFINITY, f32::min).sqrt();
        assert!(gap < 0.02, "{}: {gap} m from the body", worn.name());
        assert!(vertices.iter().all(|vertex| vertex.is_finite()));
    }
}

#[test]
fn without_the_skirt_nothing_is_sewn_and_strands_are_part_of_the_hash() {
    let text = "[skirt]\nworn = \"no\"\n[[garment]]\nkind = \"raffia-skirt\"\n";
    let mut performances = [on_stage(text), on_stage(text)];
    for performance in &mut performances {
        assert!(performance.production().garments.is_empty());
        assert!(performance.production().skirt().is_none());
        let before = performance.state_hash();
        performance.advance().expect("it stays on stage");
        assert!(before != performance.state_hash());
    }
    let [one, other] = performances;
    assert_eq!(one.state_hash(), other.state_hash());
}
