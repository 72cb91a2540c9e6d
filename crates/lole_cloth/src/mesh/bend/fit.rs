//! The bending energy at one particle as at most three numbers, worked out from where its
//! neighbors lie in the flat piece.
//!
//! A quadratic `x(r) = x_0 + g·r + ½ κ_uu u² + ½ κ_vv v² + κ_uv u v` is fitted to the neighbors by
//! least squares, so its curvatures are exact for every quadratic on every mesh. With the
//! particle's area `A` the energy is `½ A (B_u κ_uu² + B_v κ_vv² + 2 B_t κ_uv²)`. Where the
//! neighbors do not tell all three curvatures, as along a border, the energy is the least that
//! agrees with what they tell: a border that is free is bent by nothing.
//!
//! The curvatures are then mixed into measures that are orthogonal both in energy and in inverse
//! mass. Each is a constraint of its own that the others leave alone, whatever the time step.

use glam::{DMat3, DVec2, DVec3};

/// Share of the largest eigenvalue below which a curvature counts as untold. The regular
/// triangulations have shares above 0.1 or none.
const TOLD_SHARE: f64 = 0.02;

/// Sweeps of Jacobi's method; three by three converges in five.
const JACOBI_SWEEPS: usize = 12;

/// What is known about a star of particles.
pub(crate) struct Star<'a> {
    /// Neighbors, from the particle in the middle [m].
    pub(crate) offsets: &'a [DVec2],
    /// Inverse masses of the neighbors, and of the middle [1/kg].
    pub(crate) inv_masses: &'a [f64],
    pub(crate) inv_mass: f64,
    /// Area that bends with the middle [m²].
    pub(crate) area: f64,
    /// `B_u`, `B_v` and `2 B_t` [N·m].
    pub(crate) rigidities: [f64; 3],
}

/// Measures of a star: `y_k = Σ c_ki (x_i - x_0)` stores the energy `½ |y_k|²` [J].
pub(crate) struct Measures {
    /// By neighbor, its weight in each of the three.
    pub(crate) weights: Vec<[f64; 3]>,
    /// `Σ w |∂y_k|²` [1/(kg)·N/m = 1/s²].
    pub(crate) masses: [f64; 3],
}

/// The measures of a star; `None` where its neighbors tell nothing of bending.
pub(crate) fn measures(star: &Star<'_>) -> Option<Measures> {
    let told = told_curvatures(star.offsets)?;
    // Compliance of what is told: (Vᵀ D⁻¹ V) / A.
    let inv_rigidities = DVec3::from(star.rigidities.map(|rigidity| 1.0 / rigidity));
    let rank = told.directions.len();
    let compliance = |a: usize, b: usize| {
        if a < rank && b < rank {
            (told.directions[a] * inv_rigidities).dot(told.directions[b]) / star.area
        } else {
            f64::from(u8::from(a == b))
        }
    };
    let compliance = matrix(compliance);
    let center = told
        .weights
        .iter()
        .fold(DVec3::ZERO, |sum, &weight| sum - weight);
    let mut mass = outer(center, star.inv_mass);
    for (&weight, &inv_mass) in told.weights.iter().zip(star.inv_masses) {
        mass += outer(weight, inv_mass);
    }
    let inv_root = cholesky(compliance).inverse();
    let (values, vectors) = eigen(inv_root * mass * inv_root.transpose());
    let mix = vectors.transpose() * inv_root;
    let weights = told.weights.iter().map(|&weight| {
        let mixed: DVec3 = mix * weight;
        mixed.to_array()
    });
    Some(Measures {
        weights: weights.collect(),
        masses: values,
    })
}

/// Curvatures that a star tells, as a basis, and how its neighbors tell them.
struct Told {
    /// Unit vectors in `(κ_uu, κ_vv, κ_uv)`, as many as are told.
    directions: Vec<DVec3>,
    /// By neighbor, its weight in each [1/m²].
    weights: Vec<DVec3>,
}

fn told_curvatures(offsets: &[DVec2]) -> Option<Told> {
    let scale = offsets.iter().map(|offset| offset.length()).sum::<f64>() / offsets.len() as f64;
    // In units of the mean distance; nearer neighbors weigh more, so that the fit stays local.
    let rows: Vec<(DVec2, f64)> = (offsets.iter())
        .map(|&offset| {
            let unit = offset / scale;
            (unit, 1.0 / unit.length())
        })
        .collect();
    // Quadratic columns with their slopes taken out, by neighbor.
    let mut normal = glam::DMat2::ZERO;
    let mut cross = [DVec2::ZERO; 3];
    let quadratic = |unit: DVec2| {
        [
            0.5 * unit.x * unit.x,
            0.5 * unit.y * unit.y,
            unit.x * unit.y,
        ]
    };
    for &(unit, weight) in &rows {
        let square = weight * weight;
        normal += glam::DMat2::from_cols(unit * unit.x, unit * unit.y) * square;
        for (cross, value) in cross.iter_mut().zip(quadratic(unit)) {
            *cross += unit * (value * square);
        }
    }
    if normal.determinant().abs() < 1e-9 {
        return None;
    }
    let solve = normal.inverse();
    let slopes = cross.map(|cross| solve * cross);
    let mut gram = DMat3::ZERO;
    let mut columns = Vec::with_capacity(rows.len());
    for &(unit, weight) in &rows {
        let values = quadratic(unit);
        let column =
            DVec3::from([0, 1, 2].map(|k: usize| weight * (values[k] - slopes[k].dot(unit))));
        gram += outer(column, 1.0);
        columns.push(column);
    }
    let (values, vectors) = eigen(gram);
    let largest = values.into_iter().fold(0.0, f64::max);
    let kept: Vec<usize> = (0..3)
        .filter(|&k| TOLD_SHARE * largest < values[k] && 1e-9 < values[k])
        .collect();
    if kept.is_empty() {
        return None;
    }
    let directions: Vec<DVec3> = kept.iter().map(|&k| vectors.col(k)).collect();
    let weights = rows.iter().zip(&columns).map(|(&(_, weight), &column)| {
        let mut told = DVec3::ZERO;
        for (place, &k) in kept.iter().enumerate() {
            told[place] = weight * vectors.col(k).dot(column) / values[k] / (scale * scale);
        }
        told
    });
    Some(Told {
        directions,
        weights: weights.collect(),
    })
}

fn matrix(entry: impl Fn(usize, usize) -> f64) -> DMat3 {
    let column = |b: usize| DVec3::new(entry(0, b), entry(1, b), entry(2, b));
    DMat3::from_cols(column(0), column(1), column(2))
}

fn outer(vector: DVec3, factor: f64) -> DMat3 {
    DMat3::from_cols(vector * vector.x, vector * vector.y, vector * vector.z) * factor
}

/// Lower triangle `L` with `L Lᵀ` the matrix, which is positive definite.
fn cholesky(matrix: DMat3) -> DMat3 {
    let at = |row: usize, column: usize| matrix.col(column)[row];
    let l00 = at(0, 0).sqrt();
    let (l10, l20) = (at(1, 0) / l00, at(2, 0) / l00);
    let l11 = (at(1, 1) - l10 * l10).sqrt();
    let l21 = (at(2, 1) - l20 * l10) / l11;
    let l22 = (at(2, 2) - l20 * l20 - l21 * l21).sqrt();
    DMat3::from_cols(
        DVec3::new(l00, l10, l20),
        DVec3::new(0.0, l11, l21),
        DVec3::new(0.0, 0.0, l22),
    )
}

/// Eigenvalues and eigenvectors (as columns) of a symmetric matrix, by Jacobi's rotations.
fn eigen(matrix: DMat3) -> ([f64; 3], DMat3) {
    let mut a = matrix.to_cols_array_2d();
    let mut v = DMat3::IDENTITY.to_cols_array_2d();
    for _ in 0..JACOBI_SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate(&mut a, &mut v, [p, q]);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], DMat3::from_cols_array_2d(&v))
}

/// One rotation, after which the entry `p`, `q` is zero.
fn rotate(a: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], [p, q]: [usize; 2]) {
    if a[p][q] == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    let turn = |first: &mut f64, second: &mut f64| {
        (*first, *second) = (c * *first - s * *second, s * *first + c * *second);
    };
    for row in a.iter_mut() {
        let (mut first, mut second) = (row[p], row[q]);
        turn(&mut first, &mut second);
        (row[p], row[q]) = (first, second);
    }
    for rows in [a, v] {
        let (above, below) = rows.split_at_mut(q);
        for (first, second) in above[p].iter_mut().zip(&mut below[0]) {
            turn(first, second);
        }
    }
}
