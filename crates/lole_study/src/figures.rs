//! From a recorded run to the numbers of its report.

use lole_avatar::License;
use lole_body::{Dancer, Tape};
use lole_costume::document::Design;
use lole_export::dancer_sheet::{CapsuleFacts, CoverageFacts, DancerSheet};
use lole_export::report::{
    DancerMeasure, ElasticHoldFacts, GarmentFacts, MeanPercentileMax, MedianPercentile, MinMeanMax,
    PageFilm, PageMedia, Remark, ReportDivergence, ReportFile, ReportPieceOver, RunReport,
    RunSeries, SkirtFacts, Still as PageStill, Worst, report_html,
};
use lole_language::{Bilingual, Language, words};
use lole_picture::studio::STILLS;
use lole_stage::{
    Divergence, ElasticHold, FRAMES_PER_SECOND, FrameMetrics, GarmentLayers, OFF, Performance,
    Production, RunMetrics,
};

use crate::Timing;

/// What a run leaves behind.
pub struct RunFigures<'a> {
    /// What was danced.
    pub design: &'a Design,
    /// Threads of the simulation.
    pub threads: usize,
    /// What drew the pictures.
    pub renderer: String,
    /// What was measured, a picture each.
    pub metrics: &'a [FrameMetrics],
    /// How long every frame took.
    pub timings: &'a [Timing],
    /// Where the cloth flew apart, if it did.
    pub divergence: Option<Divergence>,
    /// Which piece of each garment lay outside.
    pub layers: Vec<GarmentLayers>,
    /// What the elastics of the skirt hold.
    pub hold: Option<ElasticHold>,
    /// The files that were written.
    pub files: Vec<ReportFile>,
}

/// The report of a run.
#[must_use]
pub fn report(performance: &Performance, run: RunFigures<'_>) -> RunReport {
    let worst = RunMetrics::of(run.metrics);
    let production = performance.production();
    let process: Vec<f64> = run
        .timings
        .iter()
        .map(|t| 1e3 * t.process_seconds)
        .collect();
    let wall: Vec<f64> = run.timings.iter().map(|t| 1e3 * t.wall_seconds).collect();
    let seconds = run.timings.len() as f64 / f64::from(FRAMES_PER_SECOND);
    let skin_vertices = worst.skin.sunken_cloth_vertices + worst.skin.showing_body_vertices;
    RunReport {
        lole: env!("CARGO_PKG_VERSION").to_owned(),
        particles: production.moving_count(),
        springs: performance.spring_count(),
        method: run.design.method.name.id().to_owned(),
        substeps: performance.substep_count(),
        threads: run.threads,
        frames: run.timings.len(),
        seconds,
        dance_step: run.design.motion.step.id().to_owned(),
        bpm: run.design.motion.tempo_bpm,
        seed: run.design.skirt.seed,
        renderer: run.renderer,
        frame_ms: median_and_p99(&process),
        frame_wall_ms: median_and_p99(&wall),
        realtime_factor: ratio(seconds, 1e-3 * wall.iter().sum::<f64>()),
        strain_pct: percent(worst.strain),
        strain_end_pct: percent(worst.strain_end),
        contact_body: run.design.contact_body().id().to_owned(),
        capsule_penetration_mm: Worst {
            worst: 1e3 * f64::from(worst.capsule_penetration),
        },
        skin_penetration_mm: Worst {
            worst: 1e3 * f64::from(worst.skin.worst_depth),
        },
        skin_penetration_vertices: Worst {
            worst: skin_vertices as usize,
        },
        hem_height_cm: MinMeanMax {
            min: 1e2 * f64::from(worst.hem_height[0]),
            mean: 1e2 * f64::from(worst.hem_height[1]),
            max: 1e2 * f64::from(worst.hem_height[2]),
        },
        finite: run.divergence.is_none(),
        divergence: run
            .divergence
            .map(|found| explain(&found, production, run.design)),
        no_room: performance
            .no_room()
            .map(|it| remark(&it.sentence()))
            .collect(),
        garments: run.layers.iter().map(garment_facts).collect(),
        state_hash: format!("{:016x}", performance.state_hash()),
        files: run.files,
        dancer: dancer_measures(
            &production.dancer,
            &production.design.tape(),
            production.license.as_ref(),
        ),
        skirt: skirt_facts(performance, run.hold),
        series: series(run.metrics, &process),
    }
}

/// Where and when the cloth stopped being cloth, and what to change.
#[must_use]
pub fn explain(found: &Divergence, production: &Production, design: &Design) -> ReportDivergence {
    let remedy = match design.method.name.id() {
        "xpbd" => words(
            "[method] substep_count を増やすか、[motion] tempo_bpm を下げてください",
            "raise [method] substep_count, or lower [motion] tempo_bpm",
        ),
        "fb-euler" => words(
            "[method] substep_count を増やすか、書かずに安定の限界から選ばせてください",
            "raise [method] substep_count, or leave it out so that they are chosen by the stability bound",
        ),
        _ => words(
            "この方法はずっと細かい刻みが必要です。[method] substep_count を増やすか、name を fb-euler にしてください",
            "this method needs far smaller steps: raise [method] substep_count, or choose fb-euler",
        ),
    };
    let Divergence {
        time, row, column, ..
    } = found;
    let garment = production.garments.get(found.garment);
    let particle = garment.map_or(0, |garment| {
        let columns = garment.sewn.spec.grid.column_count;
        garment.particles.start + (row * columns + column) as usize
    });
    let sentence = format!(
        "the cloth diverged at {time:.2} s at row {row} column {column} (particle {particle}); {}",
        remedy.english
    );
    let sentence_ja = format!(
        "{time:.2} 秒に {row} 行 {column} 列（質点 {particle}）で布の計算が発散しました。{}",
        remedy.japanese
    );
    ReportDivergence {
        time_s: f64::from(found.time),
        particle,
        sentence,
        sentence_ja,
    }
}

/// The tape of a dancer, and of an avatar what is measured on it.
#[must_use]
pub fn dancer_measures(
    dancer: &Dancer,
    tape: &Tape,
    license: Option<&License>,
) -> Vec<DancerMeasure> {
    let taped = dancer.taped(tape);
    let measures = taped.into_iter().map(|taped| DancerMeasure {
        key: taped.measure.key().to_owned(),
        name: taped.measure.words().english.to_owned(),
        name_ja: taped.measure.words().japanese.to_owned(),
        on_body_cm: taped.on_body.to_cm(),
        given_cm: taped.given.map(lole_geom::Length::to_cm),
        is_estimated: taped.given.is_none() && license.is_none(),
    });
    measures.collect()
}

/// Everything about a dancer that can be counted.
#[must_use]
pub fn dancer_sheet(dancer: &Dancer, tape: &Tape, license: Option<&License>) -> DancerSheet {
    let measures = dancer_measures(dancer, tape, license);
    let differences = (measures.iter())
        .filter_map(|measure| Some((measure.on_body_cm - measure.given_cm?).abs()));
    let coverage = dancer.capsule_coverage();
    let percent = |share: f32| 100.0 * f64::from(share);
    let lines = license.map(License::lines).unwrap_or_default();
    let capsules = dancer.capsules.iter().map(|capsule| CapsuleFacts {
        name: capsule.name.to_owned(),
        bones: capsule.ends.map(|(bone, _)| bone.name().to_owned()),
        ends_m: capsule.ends.map(|(_, end)| end.to_array()),
        radii_m: capsule.radii,
    });
    DancerSheet {
        lole: env!("CARGO_PKG_VERSION").to_owned(),
        avatar: None,
        license: lines
            .iter()
            .map(|line| line.text(Language::English))
            .collect(),
        worst_difference_cm: differences.reduce(f64::max),
        measures,
        capsules: capsules.collect(),
        capsule_coverage: CoverageFacts {
            close_pct: percent(coverage.close),
            outside_pct: percent(coverage.outside),
            farthest_mm: 1e3 * f64::from(coverage.farthest),
        },
        vertices: dancer.skin.positions.len(),
        triangles: dancer.skin.body_triangles().len(),
    }
}

fn skirt_facts(performance: &Performance, hold: Option<ElasticHold>) -> SkirtFacts {
    let production = performance.production();
    let license = production.license.as_ref();
    let refusal = license.and_then(License::export_refusal);
    let mut warnings: Vec<Remark> = refusal.iter().map(remark).collect();
    let Some(worn) = production.skirt() else {
        return SkirtFacts {
            design_name: design_name(performance),
            warnings,
            ..SkirtFacts::default()
        };
    };
    let (draft, skirt) = (&worn.draft, &production.design.skirt);
    warnings.extend(draft.warnings.iter().map(remark));
    warnings.extend(hold.and_then(slips));
    let overlaps = draft.elastic_rows.iter();
    let overlaps = overlaps.map(|row| row.cut_length.to_cm() - row.ring_length.to_cm());
    let overlap_cm = overlaps.fold(0.0, f64::max);
    SkirtFacts {
        is_worn: true,
        design_name: design_name(performance),
        cloth_needed_m: draft.yardage.metric.to_m(),
        cloth_needed_yd: draft.yardage.imperial.to_yd(),
        cloth_width_cm: production.design.fabric.width_cm,
        gather_ratio: skirt.gather_ratio,
        flat_width_cm: draft.flat_length.to_cm(),
        finished_length_cm: draft.finished_length.to_cm(),
        hem_height_cm: skirt.hem_height_cm,
        elastic_lengths_cm: draft
            .elastic_rows
            .iter()
            .map(|row| row.cut_length.to_cm())
            .collect(),
        elastic_hold: hold.map(|hold| ElasticHoldFacts {
            pull_n: hold.pull,
            held_n: hold.held,
            slid_cm: 1e2 * hold.slid,
            loosest_cut_cm: hold.loosest_ring.map(|ring| 1e2 * ring + overlap_cm),
        }),
        hip_girth_cm: worn.worn.hip_girth.to_cm(),
        warnings,
    }
}

/// A warning where elastics hold less than the dance pulls.
fn slips(hold: ElasticHold) -> Option<Remark> {
    if hold.pull <= hold.held {
        return None;
    }
    let cm = 1e2 * hold.slid;
    let [ends, ends_ja] = if OFF <= hold.slid {
        ["and comes off".to_owned(), "腰から落ちます".to_owned()]
    } else {
        [
            format!("and slides {cm:.1} cm down"),
            format!("{cm:.1} cm ずり落ちます"),
        ]
    };
    Some(Remark {
        sentence: format!(
            "the skirt slips in this dance: it pulls with {:.1} N, its elastics hold {:.1} N, {ends}; cut them \
             shorter, or use more rows",
            hold.pull, hold.held
        ),
        sentence_ja: format!(
            "この踊りではスカートがずれます。引く力は {:.1} N、ゴムが支える力は {:.1} N で、{ends_ja}。\
             ゴムを短くするか、段を増やしてください",
            hold.pull, hold.held
        ),
    })
}

fn garment_facts(garment: &GarmentLayers) -> GarmentFacts {
    let over = garment.over.iter().map(|over| ReportPieceOver {
        outer: over.outer.english.to_owned(),
        outer_ja: over.outer.japanese.to_owned(),
        inner: over.inner.english.to_owned(),
        inner_ja: over.inner.japanese.to_owned(),
        is_itself: over.is_itself,
        places: over.places,
    });
    GarmentFacts {
        id: garment.id.clone(),
        name: garment.name.english.to_owned(),
        name_ja: garment.name.japanese.to_owned(),
        overlapping_places: garment.places(),
        over: over.collect(),
        inverted_places: Worst {
            worst: garment.inverted,
        },
    }
}

fn remark(said: &impl Bilingual) -> Remark {
    Remark {
        sentence: said.to_string(),
        sentence_ja: said.japanese(),
    }
}

/// Step and cloth in a few words, since a design has no name of its own.
fn design_name(performance: &Performance) -> String {
    let design = &performance.production().design;
    if !design.skirt.is_worn {
        let worn = performance.production().adornments.first();
        let worn = worn.and_then(|worn| design.garments.get(worn.place));
        let worn = worn.map(|garment| garment.template.name.english);
        return format!(
            "{} · {}",
            worn.unwrap_or("costume"),
            design.motion.step.name()
        );
    }
    format!(
        "pāʻū · {} · {}",
        design.motion.step.name(),
        design.fabric.preset.name
    )
}

/// Curves of the report, one point a picture.
fn series(metrics: &[FrameMetrics], process_ms: &[f64]) -> RunSeries {
    let column = |value: fn(&FrameMetrics) -> f32| -> Vec<f64> {
        metrics
            .iter()
            .map(|frame| f64::from(value(frame)))
            .collect()
    };
    let cost_at = |time: f32| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a dance has at most 36,000 frames"
        )]
        let frame = (time * FRAMES_PER_SECOND as f32).round().max(0.0) as usize;
        process_ms
            .get(frame)
            .or(process_ms.last())
            .copied()
            .unwrap_or(0.0)
    };
    RunSeries {
        time_s: column(|frame| frame.time),
        frame_ms: metrics.iter().map(|frame| cost_at(frame.time)).collect(),
        strain_p99_pct: column(|frame| 100.0 * frame.strain.p99),
        hem_height_mean_cm: column(|frame| 100.0 * frame.hem_height),
        skin_penetration_mm: column(|frame| 1e3 * frame.skin.worst_depth),
    }
}

/// The page of a run.
#[must_use]
pub fn page(report: &RunReport, film: Option<PageFilm<'_>>, jpegs: &[Vec<u8>]) -> String {
    let stills: Vec<PageStill<'_>> = STILLS
        .iter()
        .zip(jpegs)
        .map(|(still, jpeg)| PageStill {
            caption_en: still.caption_en,
            caption_ja: still.caption_ja,
            jpeg,
        })
        .collect();
    report_html(
        report,
        PageMedia {
            film,
            stills: &stills,
        },
    )
}

/// Strain in percent.
pub(crate) fn percent(strain: lole_cloth::diagnose::StrainSummary) -> MeanPercentileMax {
    let [mean, p99, max] =
        [strain.mean, strain.p99, strain.max].map(|value| 100.0 * f64::from(value));
    MeanPercentileMax { mean, p99, max }
}

fn ratio(numerator: f64, denominator: f64) -> f64 {
    if 0.0 < denominator {
        numerator / denominator
    } else {
        0.0
    }
}

/// Median and 99th percentile: entries `n/2` and `99 n/100` of the sorted values; 0 without any.
pub(crate) fn median_and_p99(values: &[f64]) -> MedianPercentile {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |index: usize| sorted.get(index).copied().unwrap_or(0.0);
    MedianPercentile {
        median: at(sorted.len() / 2),
        p99: at(sorted.len() * 99 / 100),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_entries_of_the_sorted_values() {
        let values: Vec<f64> = (0..100).rev().map(f64::from).collect();
        let found = median_and_p99(&values);
        assert_eq!((found.median, found.p99), (50.0, 99.0));
        assert_eq!(median_and_p99(&[]).median, 0.0);
    }
}
