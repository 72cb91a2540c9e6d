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

/// Why a drawing is not drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TooMuch {
    /// It would take longer than a print may.
    Work,
    /// Its layers would take more memory than a print may.
    Memory,
}

/// Width and height of what is drawn on [pixel].
type Canvas = [f64; 2];

fn pixels([width, height]: Canvas) -> f64 {
    width * height
}

/// Checks what a drawing costs on a canvas.
pub(super) fn check(tree: &usvg::Tree, canvas: Canvas, scale: Transform) -> Result<(), TooMuch> {
    let mut count = Count {
        most: canvas.map(|side| LAYER_REACH * side),
        steps: 0.0,
        bytes: 0.0,
        depth: 0,
    };
    count.within(pixels(canvas), |count| {
        count.children(tree.root(), (scale, canvas))
    })
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

    fn children(
        &mut self,
        parent: &Group,
        (transform, canvas): (Transform, Canvas),
    ) -> Result<(), TooMuch> {
        for node in parent.children() {
            match node {
                Node::Group(group) => self.group(group, (transform, canvas))?,
                Node::Path(path) => self.path(path, (transform, canvas))?,
                Node::Text(text) => self.group(text.flattened(), (transform, canvas))?,
                Node::Image(_) => self.take(pixels(canvas))?,
            }
        }
        Ok(())
    }

    fn group(
        &mut self,
        group: &Group,
        (transform, canvas): (Transform, Canvas),
    ) -> Result<(), TooMuch> {
        let transform = transform.pre_concat(group.transform());
        if !group.should_isolate() {
            return self.within(0.0, |count| count.children(group, (transform, canvas)));
        }
        let bounds = group.layer_bounding_box().transform(transform);
        let layer = bounds.map_or(self.most, |bounds| {
            let sides = [bounds.width(), bounds.height()].map(|side| f64::from(side) + 4.0);
            [sides[0].min(self.most[0]), sides[1].min(self.most[1])]
        });
        self.within(pixels(layer), |count| {
            count.children(group, (transform, layer))?;
            for filter in group.filters() {
                count.filter(filter, (transform, layer))?;
            }
            if let Some(clip) = group.clip_path() {
                count.clip(clip, (transform, layer))?;
            }
            if let Some(mask) = group.mask() {
                count.mask(mask, (transform, layer))?;
            }
            count.take(pixels(layer))
        })
    }

    fn clip(
        &mut self,
        clip: &ClipPath,
        (transform, canvas): (Transform, Canvas),
    ) -> Result<(), TooMuch> {
        self.within(2.0 * pixels(canvas), |count| {
            let inner = transform.pre_concat(clip.transform());
            count.clipped(clip.root(), (inner, canvas))?;
            clip.clip_path()
                .map_or(Ok(()), |clip| count.clip(clip, (transform, canvas)))
        })
    }

    /// What a clip is made of: groups that are clipped again are drawn by themselves.
    fn clipped(
        &mut self,
        parent: &Group,
        (transform, canvas): (Transform, Canvas),
    ) -> Result<(), TooMuch> {
        for node in parent.children() {
            match node {
                Node::Path(path) => self.path(path, (transform, canvas))?,
                Node::Text(text) => self.clipped(text.flattened(), (transform, canvas))?,
                Node::Image(_) => {}
                Node::Group(group) => {
                    let transform = transform.pre_concat(group.transform());
                    let layer = if group.clip_path().is_some() {
                        2.0 * pixels(canvas)
                    } else {
                        0.0
                    };
                    self.within(layer, |count| {
                        count.clipped(group, (transform, canvas))?;
                        (group.clip_path())
                            .map_or(Ok(()), |clip| count.clip(clip, (transform, canvas)))
                    })?;
                }
            }
        }
        Ok(())
    }

    fn mask(
        &mut self,
        mask: &Mask,
        (transform, canvas): (Transform, Canvas),
    ) -> Result<(), TooMuch> {
        self.within(2.0 * pixels(canvas), |count| {
            count.children(mask.root(), (transform, canvas))?;
            mask.mask()
                .map_or(Ok(()), |mask| count.mask(mask, (transform, canvas)))
        })
    }

    fn path(
        &mut self,
        path: &usvg::Path,
        (transform, canvas): (Transform, Canvas),
    ) -> Result<(), TooMuch> {
        let bounds = path.stroke_bounding_box().transform(transform);
        let sides = bounds.map_or(canvas, |bounds| {
            let [width, height] = [bounds.width(), bounds.height()].map(f64::from);
            [width.min(canvas[0]), height.min(canvas[1])]
        });
        let rows = rows(path, transform, canvas[1]);
        if let Some(fill) = path.fill() {
            self.take(rows)?;
            self.paint(fill.paint(), sides, transform)?;
        }
        if let Some(stroke) = path.stroke() {
            let dashes = stroke.dasharray().map_or(0.0, |dashes| {
                let period: f32 = dashes.iter().sum();
                let bounds = path.data().bounds();
                f64::from((bounds.width() + bounds.height()) / period) * dashes.len() as f64
            });
            // Both sides of the line, and what of it is cut into dashes.
            self.take(3.0 * rows + EACH * dashes)?;
            self.paint(stroke.paint(), sides, transform)?;
        }
        Ok(())
    }

    fn paint(&mut self, paint: &Paint, sides: Canvas, transform: Transform) -> Result<(), TooMuch> {
        match paint {
            Paint::Color(_) => self.take(pixels(sides)),
            Paint::LinearGradient(_) | Paint::RadialGradient(_) => self.take(3.0 * pixels(sides)),
            Paint::Pattern(pattern) => {
                let (x, y) = transform.pre_concat(pattern.transform()).get_scale();
                let size = [pattern.rect().width() * x, pattern.rect().height() * y];
                let tile = size.map(f64::from);
                let scale = Transform::from_scale(x, y);
                self.within(pixels(tile), |count| {
                    count.children(pattern.root(), (scale, tile))
                })?;
                self.take(8.0 * pixels(sides))
            }
        }
    }

    fn filter(
        &mut self,
        filter: &filter::Filter,
        (transform, layer): (Transform, Canvas),
    ) -> Result<(), TooMuch> {
        let size = pixels(layer);
        // All results are kept until the last one is there.
        let kept = size * filter.primitives().len() as f64;
        self.within(kept, |count| {
            for primitive in filter.primitives() {
                let (x, y) = transform.get_scale();
                let scale = [f64::from(x), f64::from(y)];
                count.take(size * per_pixel(primitive.kind(), (scale, layer)))?;
                if let filter::Kind::Image(image) = primitive.kind() {
                    count.children(image.root(), (transform, layer))?;
                }
            }
            Ok(())
        })
    }
}

/// Steps of a filter for every pixel.
fn per_pixel(kind: &filter::Kind, (scale, layer): ([f64; 2], Canvas)) -> f64 {
    match kind {
        filter::Kind::ConvolveMatrix(it) => {
            4.0 * f64::from(it.matrix().columns()) * f64::from(it.matrix().rows())
        }
        filter::Kind::Morphology(it) => {
            let radii = [it.radius_x(), it.radius_y()].map(|radius| f64::from(radius.get()));
            let side = |axis: usize| (2.0 * radii[axis] * scale[axis] + 1.0).min(layer[axis]);
            side(0) * side(1)
        }
        filter::Kind::Turbulence(it) => 60.0 * f64::from(it.num_octaves()),
        filter::Kind::Merge(it) => 4.0 * it.inputs().len() as f64,
        filter::Kind::GaussianBlur(_) | filter::Kind::DropShadow(_) => 40.0,
        filter::Kind::DiffuseLighting(_) | filter::Kind::SpecularLighting(_) => 30.0,
        _ => 8.0,
    }
}

/// Rows that the edges of a path cross, all together.
fn rows(path: &usvg::Path, transform: Transform, height: f64) -> f64 {
    let row = |point: Point| {
        f64::from(point.x) * f64::from(transform.ky) + f64::from(point.y) * f64::from(transform.sy)
    };
    let mut sum = 0.0;
    let mut last = 0.0;
    let mut go = |points: &[Point]| {
        for point in points {
            let now = row(*point);
            sum += 4.0 * f64::abs(now - last).min(height) + 16.0;
            last = now;
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
    sum
}
