//! What a drawing costs to draw, counted before it is drawn: patterns, masks and clips that use each other are
//! drawn anew wherever they are used, and filters look at many pixels for each.
//!
//! The count follows how `resvg` draws, layer by layer, and leaves off as soon as it is too much, so counting
//! itself ends soon.

use resvg::tiny_skia::{PathSegment, Point, Transform};
use resvg::usvg::{self, ClipPath, Group, Mask, Node, Paint, filter};

/// Pixels that are written, one on the other, at most: about six seconds of one core.
const MOST_STEPS: f64 = 2.0e9;
/// Memory that layers take at one time, at most [byte].
const MOST_BYTES: f64 = 400.0e6;
/// Steps of whatever has no size.
const EACH: f64 = 300.0;
/// Groups in each other, at most: drawing them takes as many calls in each other.
const MOST_DEPTH: u32 = 256;
/// A layer reaches this many canvases along each side at most, as `resvg` cuts it.
const LAYER_REACH: f64 = 5.0;
const BYTES_PER_PIXEL: f64 = 4.0;
/// Nothing lies farther from the origin [pixel]: beyond, numbers of the drawing cannot tell pixels apart, and
/// `tiny-skia` loses its place in a line.
const FARTHEST: f32 = 1.0e8;

/// Why a drawing is not drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TooMuch {
    /// It would take longer than a print may.
    Work,
    /// Its layers would take more memory than a print may.
    Memory,
    /// Something in it lies too far outside.
    Far,
}

/// Width and height of what is drawn on [pixel].
type Canvas = [f64; 2];

fn pixels([width, height]: Canvas) -> f64 {
    width * height
}

/// What something is drawn on.
#[derive(Debug, Clone, Copy)]
struct Onto {
    /// From its own units to pixels.
    transform: Transform,
    canvas: Canvas,
}

impl Onto {
    /// The same for what has a transform of its own.
    fn moved(self, own: Transform) -> Self {
        Self {
            transform: self.transform.pre_concat(own),
            ..self
        }
    }
}

/// Checks what a drawing costs on a canvas.
pub(super) fn check(
    tree: &usvg::Tree,
    canvas: Canvas,
    transform: Transform,
) -> Result<(), TooMuch> {
    let mut count = Count {
        most: canvas.map(|side| LAYER_REACH * side),
        steps: 0.0,
        bytes: 0.0,
        depth: 0,
    };
    let onto = Onto { transform, canvas };
    count.within(pixels(canvas), |count| count.children(tree.root(), onto))
}

struct Count {
    /// Largest layer.
    most: Canvas,
    steps: f64,
    bytes: f64,
    depth: u32,
}

impl Count {
    fn take(&mut self, steps: f64) -> Result<(), TooMuch> {
        self.steps += steps + EACH;
        // What is no number is too much.
        if self.steps < MOST_STEPS {
            Ok(())
        } else {
            Err(TooMuch::Work)
        }
    }

    /// Does something while a layer of so many pixels is held.
    fn within(
        &mut self,
        layer: f64,
        act: impl FnOnce(&mut Self) -> Result<(), TooMuch>,
    ) -> Result<(), TooMuch> {
        let before = self.bytes;
        self.bytes += BYTES_PER_PIXEL * layer;
        self.depth += 1;
        if MOST_BYTES < self.bytes || self.bytes.is_nan() {
            return Err(TooMuch::Memory);
        }
        if MOST_DEPTH < self.depth {
            return Err(TooMuch::Work);
        }
        self.take(layer)?;
        act(self)?;
        self.bytes = before;
        self.depth -= 1;
        Ok(())
    }

    fn children(&mut self, parent: &Group, onto: Onto) -> Result<(), TooMuch> {
        for node in parent.children() {
            match node {
                Node::Group(group) => self.group(group, onto)?,
                Node::Path(path) => self.path(path, onto)?,
                Node::Text(text) => self.group(text.flattened(), onto)?,
                Node::Image(_) => self.take(pixels(onto.canvas))?,
            }
        }
        Ok(())
    }

    fn group(&mut self, group: &Group, onto: Onto) -> Result<(), TooMuch> {
        let onto = onto.moved(group.transform());
        if !group.should_isolate() {
            return self.within(0.0, |count| count.children(group, onto));
        }
        let bounds = group.layer_bounding_box().transform(onto.transform);
        let layer = bounds.map_or(self.most, |bounds| {
            let sides = [bounds.width(), bounds.height()].map(|side| f64::from(side) + 4.0);
            [sides[0].min(self.most[0]), sides[1].min(self.most[1])]
        });
        let onto = Onto {
            canvas: layer,
            ..onto
        };
        self.within(pixels(layer), |count| {
            count.children(group, onto)?;
            for filter in group.filters() {
                count.filter(filter, onto)?;
            }
            if let Some(clip) = group.clip_path() {
                count.clip(clip, onto)?;
            }
            if let Some(mask) = group.mask() {
                count.mask(mask, onto)?;
            }
            count.take(pixels(layer))
        })
    }

    fn clip(&mut self, clip: &ClipPath, onto: Onto) -> Result<(), TooMuch> {
        self.within(2.0 * pixels(onto.canvas), |count| {
            count.clipped(clip.root(), onto.moved(clip.transform()))?;
            clip.clip_path()
                .map_or(Ok(()), |clip| count.clip(clip, onto))
        })
    }

    /// What a clip is made of: groups that are clipped again are drawn by themselves.
    fn clipped(&mut self, parent: &Group, onto: Onto) -> Result<(), TooMuch> {
        for node in parent.children() {
            match node {
                Node::Path(path) => self.path(path, onto)?,
                Node::Text(text) => self.clipped(text.flattened(), onto)?,
                Node::Image(_) => {}
                Node::Group(group) => {
                    let onto = onto.moved(group.transform());
                    let layer = match group.clip_path() {
                        Some(_) => 2.0 * pixels(onto.canvas),
                        None => 0.0,
                    };
                    self.within(layer, |count| {
                        count.clipped(group, onto)?;
                        (group.clip_path()).map_or(Ok(()), |clip| count.clip(clip, onto))
                    })?;
                }
            }
        }
        Ok(())
    }

    fn mask(&mut self, mask: &Mask, onto: Onto) -> Result<(), TooMuch> {
        self.within(2.0 * pixels(onto.canvas), |count| {
            count.children(mask.root(), onto)?;
            mask.mask().map_or(Ok(()), |mask| count.mask(mask, onto))
        })
    }

    fn path(&mut self, path: &usvg::Path, onto: Onto) -> Result<(), TooMuch> {
        let bounds = path.stroke_bounding_box().transform(onto.transform);
        let edges =
            bounds.map(|bounds| [bounds.left(), bounds.top(), bounds.right(), bounds.bottom()]);
        if edges.is_some_and(|edges| edges.iter().any(|edge| FARTHEST < edge.abs())) {
            return Err(TooMuch::Far);
        }
        let canvas = bounds.map_or(onto.canvas, |bounds| {
            let [width, height] = [bounds.width(), bounds.height()].map(f64::from);
            [width.min(onto.canvas[0]), height.min(onto.canvas[1])]
        });
        let covered = Onto { canvas, ..onto };
        let way = Way::of(path, onto);
        if let Some(fill) = path.fill() {
            self.take(way.rows)?;
            self.paint(fill.paint(), covered)?;
        }
        if let Some(stroke) = path.stroke() {
            let dashes = stroke.dasharray().map_or(0.0, |dashes| {
                let period: f32 = dashes.iter().sum();
                way.length / f64::from(period) * dashes.len() as f64
            });
            // Both sides of the line, and what of it is cut into dashes.
            self.take(3.0 * way.rows + EACH * dashes)?;
            self.paint(stroke.paint(), covered)?;
        }
        Ok(())
    }

    fn paint(&mut self, paint: &Paint, onto: Onto) -> Result<(), TooMuch> {
        let covered = pixels(onto.canvas);
        match paint {
            Paint::Color(_) => self.take(covered),
            Paint::LinearGradient(_) | Paint::RadialGradient(_) => self.take(3.0 * covered),
            Paint::Pattern(pattern) => {
                let (x, y) = onto.moved(pattern.transform()).transform.get_scale();
                let size = [pattern.rect().width() * x, pattern.rect().height() * y];
                let tile = Onto {
                    transform: Transform::from_scale(x, y),
                    canvas: size.map(f64::from),
                };
                self.within(pixels(tile.canvas), |count| {
                    count.children(pattern.root(), tile)
                })?;
                self.take(8.0 * covered)
            }
        }
    }

    fn filter(&mut self, filter: &filter::Filter, onto: Onto) -> Result<(), TooMuch> {
        let size = pixels(onto.canvas);
        // All results are kept until the last one is there.
        let kept = size * filter.primitives().len() as f64;
        self.within(kept, |count| {
            for primitive in filter.primitives() {
                count.take(size * per_pixel(primitive.kind(), onto))?;
                if let filter::Kind::Image(image) = primitive.kind() {
                    count.children(image.root(), onto)?;
                }
            }
            Ok(())
        })
    }
}

/// Steps of a filter for every pixel.
fn per_pixel(kind: &filter::Kind, onto: Onto) -> f64 {
    let (x, y) = onto.transform.get_scale();
    let scale = [x, y].map(f64::from);
    match kind {
        filter::Kind::ConvolveMatrix(it) => {
            4.0 * f64::from(it.matrix().columns()) * f64::from(it.matrix().rows())
        }
        filter::Kind::Morphology(it) => {
            let radii = [it.radius_x(), it.radius_y()].map(|radius| f64::from(radius.get()));
            let side = |axis: usize| (2.0 * radii[axis] * scale[axis] + 1.0).min(onto.canvas[axis]);
            side(0) * side(1)
        }
        filter::Kind::Turbulence(it) => 60.0 * f64::from(it.num_octaves()),
        filter::Kind::Merge(it) => 4.0 * it.inputs().len() as f64,
        filter::Kind::GaussianBlur(_) | filter::Kind::DropShadow(_) => 40.0,
        filter::Kind::DiffuseLighting(_) | filter::Kind::SpecularLighting(_) => 30.0,
        _ => 8.0,
    }
}

/// How far a path goes; curves as the lines through their handles, which are no shorter.
struct Way {
    /// Rows that its edges cross, all together.
    rows: f64,
    /// Length in its own units.
    length: f64,
}

impl Way {
    fn of(path: &usvg::Path, onto: Onto) -> Self {
        let Onto { transform, canvas } = onto;
        let row = |point: Point| {
            f64::from(point.x) * f64::from(transform.ky)
                + f64::from(point.y) * f64::from(transform.sy)
        };
        let mut way = Self {
            rows: 0.0,
            length: 0.0,
        };
        let mut last = Point::zero();
        let mut go = |points: &[Point]| {
            for &point in points {
                let rows = f64::abs(row(point) - row(last)).min(canvas[1]);
                way.rows += 4.0 * rows + 16.0;
                way.length += f64::from(point.distance(last));
                last = point;
            }
        };
        for segment in path.data().segments() {
            match segment {
                PathSegment::MoveTo(to) | PathSegment::LineTo(to) => go(&[to]),
                PathSegment::QuadTo(a, to) => go(&[a, to]),
                PathSegment::CubicTo(a, b, to) => go(&[a, b, to]),
                PathSegment::Close => {}
            }
        }
        way
    }
}
