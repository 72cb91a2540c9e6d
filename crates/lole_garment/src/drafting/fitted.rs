//! What fitted garments share: pieces of the block's halves, sides with a dart, a bound neckline.

use kurbo::{PathSeg, Point, Vec2};
use lole_geom::Length;
use lole_language::{Sentence, words};
use lole_pattern::pattern::{Seam, Step, StepFigure};
use lole_pattern::piece::{CutCount, Edge, Finish, LineKind, Mark, Piece};
use lole_pattern::sold_zip;

use super::block::{Block, Half, SideDart};
use super::making::{both_sides, cm, edges_of, plain, say, side, step};
use super::shape::{CM, Label, curve, edge, length, line, marked};
use super::work::{Work, minutes};

/// Allowance of seams [m], of sides and shoulders, which are fitted once more on the body [m].
pub(crate) const SEAM: f64 = 1.0 * CM;
pub(crate) const FITTED_SEAM: f64 = 1.5 * CM;
/// Allowance of a bound neckline: it lies inside the binding [m].
pub(crate) const BOUND: f64 = 0.7 * CM;

/// The side of a piece from the hem up to the underarm.
#[derive(Debug, Clone)]
pub(crate) struct SideLine {
    /// From the hem up, with the mouth of the dart in it.
    pub(crate) way: Vec<PathSeg>,
    /// Where the dart's mouth begins and ends along it, as shares; equal without a dart.
    pub(crate) mouth: [f64; 2],
    pub(crate) dart: Option<SideDart>,
}

impl SideLine {
    /// A side without a dart.
    pub(crate) const fn plain(way: Vec<PathSeg>) -> Self {
        Self {
            way,
            mouth: [1.0, 1.0],
            dart: None,
        }
    }

    /// The side of a front whose underarm was pivoted: `flat` runs up to the underarm as it was before,
    /// its last segment straight. The dart lies `below` the underarm on it.
    pub(crate) fn with_dart(flat: &[PathSeg], block: &Block, below: f64) -> Self {
        use kurbo::{Affine, ParamCurve as _};
        let Some((last, rest)) = flat.split_last() else {
            return Self::plain(Vec::new());
        };
        let (start, end) = (last.start(), last.end());
        let long = (end - start).hypot();
        let share = (1.0 - below / long.max(1.0e-9)).clamp(0.2, 0.9);
        let lower = last.eval(share);
        let down = (start - end) / long.max(1.0e-9);
        let pivot = Affine::rotate_about(block.dart_angle, block.bust_point);
        let Some(dart) = block.side_dart(lower, down) else {
            return Self::plain(flat.to_vec());
        };
        let mut way = rest.to_vec();
        way.push(line(start, lower));
        let before = length(&way);
        way.extend([line(lower, dart.roof), line(dart.roof, dart.legs[1])]);
        let after = length(&way);
        way.push(line(dart.legs[1], pivot * end));
        let whole = length(&way);
        Self {
            way,
            mouth: [before / whole, after / whole],
            dart: Some(dart),
        }
    }

    /// Both legs of the dart and its point.
    pub(crate) fn marks(&self) -> Vec<Mark> {
        let Some(dart) = &self.dart else {
            return Vec::new();
        };
        let leg = |index: usize| marked(LineKind::Dart, &[dart.legs[index], dart.apex]);
        let point = Mark::Point {
            name: words("ダーツ止まり", "end of the dart"),
            at: dart.apex,
        };
        vec![leg(0), leg(1), point]
    }

    /// This side, which is edge `front.1` of piece `front.0`, sewn to a side of the same length without
    /// the dart: below it and above it, on both sides of the body.
    pub(crate) fn seams(&self, front: (usize, usize), back: (usize, usize)) -> Vec<Seam> {
        let front = side(front.0, 0, front.1);
        let back = side(back.0, 0, back.1);
        let [from, to] = self.mouth;
        let sewn = from + (1.0 - to);
        let share = from / sewn;
        if self.dart.is_none() {
            return both_sides(plain(back, front)).to_vec();
        }
        let below = plain(back.between(0.0, share), front.between(0.0, from));
        let above = plain(back.between(share, 1.0), front.between(to, 1.0));
        [both_sides(below), both_sides(above)].concat()
    }
}

/// Armhole, shoulder and neckline of a half, in the order of a piece's edges.
pub(crate) fn upper_edges(half: &Half) -> [Edge; 3] {
    let [tip, neck] = half.shoulder;
    [
        edge("armhole", half.armhole.clone(), Finish::Seam, SEAM),
        edge("shoulder", vec![line(tip, neck)], Finish::Seam, SEAM),
        edge("neckline", half.neckline.clone(), Finish::Seam, BOUND),
    ]
}

/// Width of the strip that binds a neckline [m]: twice the finished binding and what is turned.
const BINDING: f64 = 3.2 * CM;

/// A strip on the bias around a neckline of this length, its ends turned in at the opening of the back or
/// sewn to a ring.
pub(crate) fn binding(neckline: f64, ends: Finish) -> Piece {
    let label = Label::main(
        "binding",
        words("衿ぐりのバイアス布", "binding of the neckline"),
        CutCount::Alike(1),
    );
    let sides = [
        ("lower", Finish::Seam, BOUND),
        ("left_end", ends, SEAM),
        ("upper", Finish::Hem, BOUND),
        ("right_end", ends, SEAM),
    ];
    let bias = Vec2::new(1.0, 1.0) * std::f64::consts::FRAC_1_SQRT_2;
    let height = BINDING - 2.0 * BOUND;
    let mut piece = super::shape::rectangle(label, [neckline, height], sides, bias);
    let middle = 0.5 * height;
    let fold = super::shape::across(LineKind::TopFold, middle, [0.0, neckline]);
    piece.marks.push(fold);
    piece
}

/// The binding's lower edge along the necklines of back and front: it begins at the middle of the back
/// and runs over the wearer's left. `back` and `front` name piece and edge, whose ways run from the
/// shoulder to the middle.
pub(crate) fn binding_seams(
    pieces: &[Piece],
    binding: usize,
    [back, front]: [(usize, usize); 2],
) -> Vec<Seam> {
    let way = |(piece, edge): (usize, usize)| pieces[piece].edges[edge].length();
    let (of_back, of_front) = (way(back), way(front));
    let total = 2.0 * (of_back + of_front);
    let stops = [
        0.0,
        of_back / total,
        0.5,
        (of_back + 2.0 * of_front) / total,
        1.0,
    ];
    let flat = |(piece, edge), copy| side(piece, copy, edge);
    let parts = [
        flat(back, 0).back(),
        flat(front, 0),
        flat(front, 1).back(),
        flat(back, 1),
    ];
    let ring = plain(side(binding, 0, 1), side(binding, 0, 3).back());
    let is_ring = pieces[binding].edges[1].finish == Finish::Seam;
    let along = (0..4).map(|index| {
        plain(
            parts[index],
            side(binding, 0, 0).between(stops[index], stops[index + 1]),
        )
    });
    is_ring.then_some(ring).into_iter().chain(along).collect()
}

/// How a neckline is bound.
pub(crate) fn binding_step(neckline: f64, figure: StepFigure) -> Step {
    let [long_cm, wide_cm] = [neckline + 2.0 * SEAM, BINDING].map(cm);
    step(
        words("衿ぐりを始末する", "Bind the neckline"),
        say!(
            "幅 {wide_cm} cm、長さ {long_cm} cm のバイアス布で衿ぐりをくるみます。肩と前中心の合印を合わせて中表に縫い、裏へ折ってまわりを縫います。",
            "Bind the neckline with a bias strip of {wide_cm} by {long_cm} cm: sew it on right sides together, its notches at the shoulders and the middle of the front, fold it to the inside over the allowance and stitch."
        ),
        minutes(&[(Work::Binding, neckline)]),
    )
    .or_by_hand(say!(
        "表から半返し縫いで付け、裏はまつります。",
        "Sew it on with half back stitches and slip-stitch the inside."
    ))
    .shown(figure)
}

/// How pieces are cut and marked.
pub(crate) fn cutting_step(pieces: &[Piece]) -> Step {
    let count: u32 = pieces.iter().map(|piece| piece.cut.pieces()).sum();
    let is_dart = |mark: &Mark| matches!(mark, Mark::Line { kind, .. } if *kind == LineKind::Dart);
    let has_darts = pieces.iter().any(|piece| piece.marks.iter().any(is_dart));
    let [marked_japanese, marked_english] = if has_darts {
        ["合印とダーツ", "notches and darts"]
    } else {
        ["合印", "all notches"]
    };
    step(
        words("布を裁つ", "Cut out"),
        say!(
            "型紙には縫い代が入っています。そのまま外の線で、型紙に書いてある枚数を裁ちます。布は広げて一枚で置き、裁ち方図のように地の目を合わせます。「わ」の型紙は半身です。写したら「わ」の線で裏返して続きを写し、左右をつなげて一枚に裁ちます（布を二つ折りにするときは、折り山に「わ」を合わせます）。「左右」の型紙は、二枚目を裏返して写します。{marked_japanese}を写します。",
            "The patterns include their seam allowances: cut as many pieces of cloth as each says, along the outer lines. Spread the cloth in a single layer and lay them along the grain as the cut plan shows. A pattern with a fold line is one half: draw it, turn it over along the fold line, draw the other half, and cut both in one (on doubled cloth the fold line lies on the fold). Of a pair, turn the pattern over for the second piece. Mark {marked_english}."
        ),
        minutes(&[(Work::Piece, f64::from(count)), (Work::Piece, 3.0)]),
    )
    .cutting()
}

/// How a side dart is sewn; `None` where there is none.
pub(crate) fn dart_step(piece: usize, line: &SideLine, marks: [usize; 2]) -> Option<Step> {
    let dart = line.dart.as_ref()?;
    let wide = (dart.legs[1] - dart.legs[0]).hypot();
    let long = (dart.legs[0] - dart.apex).hypot();
    let [wide_cm, long_cm] = [wide, long].map(cm);
    let figure = StepFigure::Piece {
        piece,
        edges: Vec::new(),
        marks: marks.to_vec(),
    };
    Some(
        step(
            words("胸のダーツを縫う", "Sew the bust darts"),
            say!(
                "脇で幅 {wide_cm} cm、長さ {long_cm} cm のダーツを左右とも縫い、下へ倒してアイロンをかけます。先は返し縫いをせずに糸を結びます。",
                "Sew the darts of {wide_cm} cm at the side and {long_cm} cm long on both sides and press them down. Knot the threads at the point instead of sewing back."
            ),
            minutes(&[(Work::Dart, 2.0)]),
        )
        .shown(figure),
    )
}

/// A back shoulder that is longer by less is sewn to the front without a word [m].
const LEAST_EASE: f64 = 1.0e-3;

/// The zip that is bought for an opening [m].
pub(crate) fn zip_note(opening: f64) -> Sentence {
    let opening = Length::from_m(opening);
    let (sold, long) = (sold_zip(opening).to_cm(), opening.to_cm());
    say!(
        "あき {long:.1} cm。{sold:.0} cm のものを買い、長い分は下を縫い止めて切る",
        "for an opening of {long:.1} cm buy one of {sold:.0} cm; sew across it below the opening and cut off the rest"
    )
}

/// How `meters` of sides and shoulders are closed; the shoulder's front and back are so long [m].
pub(crate) fn closing_step(
    title: lole_language::Words,
    (meters, [front, back]): (f64, [f64; 2]),
    seams: Vec<usize>,
) -> Step {
    let [seam_cm, side_cm] = [SEAM, FITTED_SEAM].map(cm);
    let longer_cm = cm(back - front);
    let eased = if LEAST_EASE < back - front {
        say!(
            "肩の後ろは前より {longer_cm} cm 長く裁ってあります。切り落としたり前を伸ばしたりせず、後ろを下にして両端を合わせ、間をいせて縫います。",
            "The back shoulder is cut {longer_cm} cm longer than the front, for the blade below it: do not trim it nor stretch the front, but match both ends, put the back underneath and ease it in. "
        )
    } else {
        Sentence::new("", "")
    };
    let [japanese, english] = [&eased.japanese, &eased.english];
    step(
        title,
        say!(
            "合印どうしを合わせて中表に置き、肩は {seam_cm} cm、脇は {side_cm} cm の縫い代で縫います。{japanese}端を始末し、後ろへ倒します。",
            "Right sides together and notch on notch, sew the shoulders with {seam_cm} cm and the sides with {side_cm} cm of allowance. {english}Neaten the edges and press them to the back."
        ),
        minutes(&[(Work::Seam, meters)]),
    )
    .shown(StepFigure::Seams(seams))
}

/// How far the edge of a hem of this depth is longer than where it is sewn to, because the hem bends [m].
pub(crate) fn hem_fullness(edge: &Edge, depth: f64) -> f64 {
    let points = edge.points(1.0e-3);
    let ways: Vec<Vec2> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let turns = ways.windows(2).map(|pair| {
        let [one, other] = [pair[0], pair[1]];
        lole_geom::trig64::atan2(one.cross(other), one.dot(other))
    });
    depth * turns.sum::<f64>().abs()
}

/// A hem whose edge is longer by less is folded without a word [m].
const LEAST_FULLNESS: f64 = 0.01;

/// How a hem is turned up; each of its pieces has so much too much of it where it bends ([`hem_fullness`]).
pub(crate) fn hem_step((depth, fullness): (f64, f64), around: f64, figure: StepFigure) -> Step {
    let [depth_cm, around_cm, full_cm] = [depth, around, fullness].map(cm);
    let eased = if LEAST_FULLNESS < fullness {
        say!(
            "裾の丸いところでは、折り代の端が一枚につき {full_cm} cm 余ります。端から 0.5 cm を粗くぐし縫いし、糸を引いて縮め、アイロンで平らになじませてから縫います。",
            " Where the hem bends, its edge has {full_cm} cm too much in each piece: run a long stitch 0.5 cm from the edge, draw it up until the fold lies flat, and press before you sew."
        )
    } else {
        Sentence::new("", "")
    };
    let [japanese, english] = [&eased.japanese, &eased.english];
    step(
        words("裾を上げる", "Hem"),
        say!(
            "裾を {depth_cm} cm 折り上げ、端を 1 cm 折り込んで、{around_cm} cm を縫います。{japanese}",
            "Turn up {depth_cm} cm, its edge turned under by 1 cm, and stitch around, {around_cm} cm.{english}"
        ),
        minutes(&[(Work::Hem, around)]),
    )
    .or_by_hand(say!("端を折り込み、奥をまつります。", "Turn the edge under and blind-stitch it."))
    .shown(figure)
}

/// The edge of a way down the middle, from the neckline to the hem.
pub(crate) fn center_edge(id: &'static str, way: Vec<PathSeg>, finish: Finish) -> Edge {
    let allowance = if finish == Finish::Fold {
        0.0
    } else {
        FITTED_SEAM
    };
    edge(id, way, finish, allowance)
}

/// A hem from the middle, level there, to the side; straight where both are on one level.
pub(crate) fn rising_hem(middle: Point, side: Point) -> PathSeg {
    let rise = side.y - middle.y;
    if rise.abs() < LEVEL {
        return line(middle, side);
    }
    // A parabola.
    let third = (side.x - middle.x) / 3.0;
    curve(
        middle,
        Vec2::new(third, 0.0),
        Vec2::new(third, 2.0 * rise / 3.0),
        side,
    )
}

/// Heights nearer than this are one [m].
const LEVEL: f64 = 1.0e-9;

/// Edges of a piece, from its `n`th on, are found by their names.
pub(crate) fn place(piece: &Piece, id: &str) -> usize {
    let found = piece.edges.iter().position(|edge| edge.id == id);
    debug_assert!(found.is_some(), "no edge {id} in {}", piece.id);
    found.unwrap_or_default()
}

/// The figure of whole edges.
pub(crate) fn shown(pieces: &[Piece], piece: usize, ids: &[&str]) -> StepFigure {
    let edges: Vec<usize> = ids.iter().map(|id| place(&pieces[piece], id)).collect();
    edges_of(piece, &edges)
}
