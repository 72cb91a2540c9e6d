//! Laws of the film's camera: wherever she dances, in whatever format, nothing of her is cut off, and she is as
//! large as the dance lets her be.

use glam::{Vec2, Vec3};
use lole_body::Bone;
use lole_costume::document;
use lole_geom::trig;
use lole_picture::film::{self, FilmCamera, Framing, Placed, room};
use lole_render::{Camera, Size};
use lole_stage::{Formation, Performance, Production};

/// Landscape, upright as a telephone, square.
const FORMATS: [Size; 3] = [
    Size {
        width: 1280,
        height: 720,
    },
    Size {
        width: 720,
        height: 1280,
    },
    Size {
        width: 720,
        height: 720,
    },
];

const DANCERS: [&str; 3] = [
    "[dancer]\nfigure = \"woman\"\n",
    "[dancer]\nfigure = \"child\"\nstature_cm = 105\n",
    "[dancer]\nfigure = \"man\"\nstature_cm = 186\nhip_cm = 112\nwaist_cm = 104\n",
];

/// Where a point is in the picture, from -1 at the left and bottom to 1.
fn seen_at(camera: &Camera, size: Size, point: Vec3) -> [f32; 2] {
    let backward = (camera.eye - camera.target).normalize_or_zero();
    let right = Vec3::Y.cross(backward).normalize_or_zero();
    let away = point - camera.eye;
    let focal = 1.0 / trig::tan(camera.vertical_fov * 0.5);
    let depth = -away.dot(backward);
    [
        focal * away.dot(right) / depth / size.aspect(),
        focal * away.dot(backward.cross(right)) / depth,
    ]
}

/// Whether all points are in the picture, in every format.
fn all_seen(points: &[Vec3], views: &[Camera; 3], place: impl Fn() -> String) {
    for (camera, size) in views.iter().zip(FORMATS) {
        for &point in points {
            let at = seen_at(camera, size, point);
            let is_seen = at.iter().all(|it| it.abs() < 1.0);
            assert!(
                is_seen,
                "{}: {point} is seen at {at:?} of {size:?}",
                place()
            );
        }
    }
}

/// Dances, calls with the cameras of every format, seven times a second.
fn film(text: &str, seconds: f32, look: &mut dyn FnMut(&Performance, &[Camera; 3])) {
    let design = document::parse(&format!("lole = 1\n{text}"), "test").expect("a design");
    let mut performance = Performance::new(Production::new(&design).expect("made")).expect("worn");
    while performance.time() < 0.0 {
        performance.advance().expect("nothing flies away");
    }
    let cameras = FORMATS.map(|_| FilmCamera::new(&performance));
    while performance.time() < seconds {
        for _ in 0..8 {
            performance.advance().expect("nothing flies away");
        }
        performance.pose_body();
        let views: [Camera; 3] =
            std::array::from_fn(|format| cameras[format].view(&performance, FORMATS[format]));
        look(&performance, &views);
    }
}

#[test]
fn nothing_of_a_dancer_is_cut_off_in_any_format() {
    for dancer in DANCERS {
        for step in ["kaholo", "ami-kuu", "lele", "uwehe", "kalakaua"] {
            let text = format!("[skirt]\nworn = \"no\"\n{dancer}[motion]\nstep = \"{step}\"\n");
            film(&text, 9.0, &mut |performance, views| {
                let place = || format!("{step}, {dancer}, {} s", performance.time());
                all_seen(performance.body_positions(), views, place);
            });
        }
    }
}

#[test]
fn a_dancer_fills_the_picture_as_far_as_her_arms_let_her() {
    let mut heights = FORMATS.map(|_| 0.0_f32);
    film(
        "[skirt]\nworn = \"no\"\n",
        6.0,
        &mut |performance, views| {
            let hips = performance.world_from_bind()[Bone::Hips.index()].translation;
            let feet = Vec3::new(hips.x, 0.0, hips.z);
            let crown = performance.production().dancer.landmarks.crown_height * Vec3::Y + feet;
            for (height, (camera, size)) in heights.iter_mut().zip(views.iter().zip(FORMATS)) {
                let [low, high] = [feet, crown].map(|it| seen_at(camera, size, it)[1]);
                *height = height.max(0.5 * (high - low));
            }
        },
    );
    let [landscape, upright, square] = heights;
    assert!(0.80 < landscape, "{heights:?}");
    assert!(0.80 < square, "{heights:?}");
    assert!(0.55 < upright, "{heights:?}");
}

#[test]
fn a_skirt_that_swings_stays_in_an_upright_picture() {
    let text = "[skirt]\ncolumn_count = 128\nrow_count = 14\n[motion]\nstep = \"ami-kuu\"\ntempo_bpm = 120\n";
    film(text, 4.0, &mut |performance, views| {
        all_seen(performance.cloth_positions(), views, || {
            performance.time().to_string()
        });
    });
}

/// Dancers of one step, about to dance.
fn dancers(step: &str) -> Vec<Performance> {
    let ready = |dancer: &&str| {
        let text =
            format!("lole = 1\n[skirt]\nworn = \"no\"\n{dancer}[motion]\nstep = \"{step}\"\n");
        let design = document::parse(&text, "test").expect("a design");
        let mut performance =
            Performance::new(Production::new(&design).expect("made")).expect("worn");
        while performance.time() < 0.0 {
            performance.advance().expect("nothing flies away");
        }
        performance
    };
    DANCERS.iter().map(ready).collect()
}

/// A line of three walks into a heap: the camera comes nearer with them, softly, and nobody is ever cut off.
#[test]
fn the_camera_comes_near_as_a_group_draws_together() {
    let ways = [-1.6_f32, 0.0, 1.6].map(|x| Vec2::new(-0.6 * x, 0.0));
    let mut group: Vec<Performance> = (ways.into_iter())
        .map(|way| {
            let part = "[[motion.part]]\nstep = \"kaholo\"\n";
            let text = format!(
                "lole = 1\n[skirt]\nworn = \"no\"\n[motion]\ntempo_bpm = 120\n\
                 {part}beat_count = 16\nformation = \"line\"\n\
                 {part}beat_count = 48\nformation = \"circle\"\n{part}beat_count = 16\n"
            );
            let design = document::parse(&text, "test").expect("a design");
            let mut performance =
                Performance::new(Production::new(&design).expect("made")).expect("worn");
            performance
                .walk(&[Vec2::ZERO, way, Vec2::ZERO])
                .expect("her feet carry her");
            while performance.time() < 0.0 {
                performance.advance().expect("nothing flies away");
            }
            performance
        })
        .collect();
    let places = [-1.6_f32, 0.0, 1.6].map(|x| Vec3::X * x);
    let camera = FilmCamera::of_group(&placed(&group, &places));
    let mut distances = Vec::new();
    while group[0].time() < 40.0 {
        for performance in &mut group {
            for _ in 0..12 {
                performance.advance().expect("nothing flies away");
            }
            performance.pose_body();
        }
        let placed = placed(&group, &places);
        let views = FORMATS.map(|size| camera.group_view(&placed, size));
        for dancer in &placed {
            let body = dancer.performance.body_positions().iter();
            let body: Vec<Vec3> = body.map(|place| place + dancer.at).collect();
            all_seen(&body, &views, || format!("{} s", group[0].time()));
        }
        distances.push(views[0].eye.distance(views[0].target));
    }
    let [first, last] = [distances[0], distances[distances.len() - 1]];
    assert!(last < 0.8 * first, "{first} to {last} m");
    let jump = distances.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let jump = jump.fold(0.0, f32::max);
    assert!(jump < 0.05 * first, "{jump} of {first} m within 0.2 s");
}

/// Each where she stands.
fn placed<'a>(group: &'a [Performance], places: &[Vec3]) -> Vec<Placed<'a>> {
    let placed = group.iter().zip(places);
    placed
        .map(|(performance, &at)| Placed { performance, at })
        .collect()
}

#[test]
fn everybody_of_a_group_is_seen_and_no_hand_reaches_a_neighbor() {
    for step in ["kaholo", "uwehe", "kaapuni"] {
        let mut group = dancers(step);
        let room = room(&group.iter().collect::<Vec<_>>());
        assert!(room < 3.0, "{step}: {room} m");
        let places = Formation::Line.places(group.len(), room);
        let camera = FilmCamera::of_group(&placed(&group, &places));
        while group[0].time() < 9.0 {
            for performance in &mut group {
                for _ in 0..8 {
                    performance.advance().expect("nothing flies away");
                }
                performance.pose_body();
            }
            let placed = placed(&group, &places);
            let views = FORMATS.map(|size| camera.group_view(&placed, size));
            let bodies = placed.iter().map(|dancer| {
                let body = dancer.performance.body_positions().iter();
                body.map(|place| place + dancer.at).collect::<Vec<Vec3>>()
            });
            let place = || format!("{step}, {} s", group[0].time());
            let mut right_before = f32::MIN;
            for body in bodies {
                all_seen(&body, &views, place);
                let left = body.iter().map(|it| it.x).fold(f32::MAX, f32::min);
                assert!(right_before < left, "{}", place());
                right_before = body.iter().map(|it| it.x).fold(f32::MIN, f32::max);
            }
        }
    }
}

#[test]
fn a_film_is_cut_on_counts_and_moves_softly_between_them() {
    let text = "[skirt]\nworn = \"no\"\n[motion]\nstep = \"ami-kuu\"\ntempo_bpm = 100\n[stage]\ncamera = \"cuts\"\n";
    let mut shot_before: Option<(usize, Camera)> = None;
    let mut seen = 0_usize;
    film(text, 26.0, &mut |performance, views| {
        let (cuts, framings) = film::cuts(performance);
        let time = performance.time();
        let shot = cuts.partition_point(|&cut| cut <= time);
        let hips = performance.world_from_bind()[Bone::Hips.index()];
        let skeleton = &performance.production().dancer.skeleton;
        let hips = hips.transform_point3(skeleton.joint(Bone::Hips));
        let shown = performance.body_positions().iter().copied();
        let shown: Vec<Vec3> = match framings[shot] {
            Framing::Whole => shown.collect(),
            Framing::Upper => shown.filter(|place| hips.y < place.y).collect(),
        };
        all_seen(&shown, views, || format!("shot {shot}, {time} s"));
        if let Some((number, camera)) = shot_before {
            let moved = camera.eye.distance(views[0].eye);
            if number == shot {
                assert!(
                    moved < 0.25,
                    "{moved} m in a seventh of a second at {time} s"
                );
            } else {
                assert!(0.5 < moved, "{moved} m from shot to shot at {time} s");
                seen += 1;
            }
        }
        shot_before = Some((shot, views[0]));
    });
    assert!(4 <= seen, "{seen} cuts");
    let design = document::parse(&format!("lole = 1\n{text}"), "test").expect("a design");
    let performance = Performance::new(Production::new(&design).expect("made")).expect("worn");
    let lole_stage::Danced::Step(dance) = &performance.production().dance else {
        panic!("a step");
    };
    let counts: Vec<f64> = dance.counts(600.0).iter().map(|count| count.time).collect();
    let (cuts, _) = film::cuts(&performance);
    for cut in &cuts {
        let is_count = counts
            .iter()
            .any(|time| (time - f64::from(*cut)).abs() < 1.0e-4);
        assert!(is_count, "{cut} s");
    }
    for pair in cuts.windows(2) {
        assert!(2.9 < pair[1] - pair[0], "{pair:?}");
    }
}

#[test]
fn a_turntable_goes_once_around_her_and_loses_nothing() {
    let text = "[skirt]\nworn = \"no\"\n[stage]\ncamera = \"turntable\"\n";
    let mut quarters = [false; 4];
    film(text, 12.0, &mut |performance, views| {
        all_seen(performance.body_positions(), views, || {
            format!("{} s", performance.time())
        });
        let arm = views[0].eye - views[0].target;
        quarters[2 * usize::from(arm.z < 0.0) + usize::from(arm.x < 0.0)] = true;
    });
    assert_eq!(quarters, [true; 4]);
}
