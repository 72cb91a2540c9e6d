//! Laws of the film's camera: wherever she dances, in whatever format, nothing of her is cut off, and she is as
//! large as the dance lets her be.

use glam::Vec3;
use lole_body::Bone;
use lole_costume::document;
use lole_geom::trig;
use lole_picture::film::{FilmCamera, Placed, room};
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

#[test]
fn everybody_of_a_group_is_seen_and_no_hand_reaches_a_neighbor() {
    for step in ["kaholo", "uwehe", "kaapuni"] {
        let text = |dancer: &str| {
            format!("lole = 1\n[skirt]\nworn = \"no\"\n{dancer}[motion]\nstep = \"{step}\"\n")
        };
        let mut group: Vec<Performance> = DANCERS
            .iter()
            .map(|dancer| {
                let design = document::parse(&text(dancer), "test").expect("a design");
                Performance::new(Production::new(&design).expect("made")).expect("worn")
            })
            .collect();
        for performance in &mut group {
            while performance.time() < 0.0 {
                performance.advance().expect("nothing flies away");
            }
        }
        let room = room(&group.iter().collect::<Vec<_>>());
        assert!(room < 3.0, "{step}: {room} m");
        let places = Formation::Line.places(group.len(), room);
        let placed = |group: &[Performance], camera: &mut dyn FnMut(&[Placed<'_>])| {
            let placed = group.iter().zip(&places);
            let placed: Vec<Placed<'_>> = placed
                .map(|(performance, &at)| Placed { performance, at })
                .collect();
            camera(&placed);
        };
        let mut cameras = Vec::new();
        placed(&group, &mut |placed| {
            cameras.push(FilmCamera::of_group(placed))
        });
        while group[0].time() < 9.0 {
            for performance in &mut group {
                for _ in 0..8 {
                    performance.advance().expect("nothing flies away");
                }
                performance.pose_body();
            }
            placed(&group, &mut |placed| {
                let views = FORMATS.map(|size| cameras[0].group_view(placed, size));
                let mut ends = Vec::new();
                for dancer in placed {
                    let body = dancer.performance.body_positions().iter();
                    let body: Vec<Vec3> = body.map(|place| place + dancer.at).collect();
                    all_seen(&body, &views, || {
                        format!("{step}, {} s", dancer.performance.time())
                    });
                    let sides = body.iter().map(|place| place.x);
                    ends.push(sides.fold((f32::MAX, f32::MIN), |(low, high), x| {
                        (low.min(x), high.max(x))
                    }));
                }
                for pair in ends.windows(2) {
                    assert!(pair[0].1 < pair[1].0, "{step}: {ends:?}");
                }
            });
        }
    }
}
