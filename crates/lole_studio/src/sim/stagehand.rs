//! The work of the simulation, one turn after the other.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError};

use glam::Vec3;
use lole_cloth::Crossings;
use lole_costume::document::{Design, Uncrossed};
use lole_language::Sentence;
use lole_picture::{Moment, Scenery};
use lole_stage::{Show, Wish};

use super::pace::Pace;
use super::repair::Repair;
use super::sewing::{Entrance, Sewn, wardrobe};
use super::{Input, News, Outbox};
use crate::clock::Clock;
use crate::command::Watch;
use crate::history::Sample;
use crate::platform::{self, Sewing};
use crate::snapshot::Wardrobe;
use crate::{Command, Snapshot};

/// Threads of the cloth: more do not help a single skirt, and one core is left to the picture.
const MOST_THREADS: usize = 4;
/// Cloth below the skin is looked for this often while she dances [s]: it takes as long as a few
/// frames.
const SUNKEN_INTERVAL: f64 = 0.4;
/// Samples kept for a picture that is not taken, as while the window is minimized.
const MOST_SAMPLES: usize = 600;

/// When there is something to do again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rest {
    /// At once.
    None,
    /// In so many seconds, or when something is sent.
    Until(f64),
    /// When something is sent.
    Called,
    /// Never: it was told to quit.
    Ended,
}

/// Whoever keeps the show going.
pub(crate) struct Stagehand {
    inputs: Sender<Input>,
    outbox: Box<dyn Outbox>,
    clock: Clock,
    pace: Pace,
    repair: Repair,
    pool: Option<rayon::ThreadPool>,
    stage: Option<(Show, Arc<Wardrobe>)>,
    sewing: Option<Sewing>,
    /// The newest design that was wished while another one was being sewn.
    next: Option<Design>,
    plays: bool,
    /// Frames that are danced although the show stands still.
    steps: u32,
    speed: f64,
    watch: Watch,
    /// Cloth below the skin as it was last looked for, and when.
    sunken: (f64, Vec<Vec3>),
    samples: Vec<Sample>,
    /// Whether there is something new to see.
    is_stale: bool,
    quits: bool,
}

impl Stagehand {
    /// Begins to sew `design`; `inputs` is where what reaches it is sent.
    pub(crate) fn new(
        design: Design,
        entrance: Entrance,
        inputs: Sender<Input>,
        outbox: Box<dyn Outbox>,
    ) -> Self {
        let clock = Clock::start();
        let threads = platform::cores().saturating_sub(1).clamp(1, MOST_THREADS);
        let pool = platform::pool(threads);
        let mut hand = Self {
            inputs,
            outbox,
            clock,
            pace: Pace::new(clock.seconds(), 1.0),
            repair: Repair::default(),
            pool,
            stage: None,
            sewing: None,
            next: None,
            plays: true,
            steps: 0,
            speed: 1.0,
            watch: Watch::default(),
            sunken: (f64::MIN, Vec::new()),
            samples: Vec::new(),
            is_stale: false,
            quits: false,
        };
        hand.sew(design, entrance);
        hand
    }

    /// Obeys, dances one frame where it is due, and hands out what is new; says how long there is nothing to do.
    pub(crate) fn turn(&mut self, inputs: &Receiver<Input>) -> Rest {
        self.obey(inputs);
        if self.quits {
            return Rest::Ended;
        }
        let mut rest = Rest::None;
        if self.may_dance() {
            let wait = self.pace.wait(self.clock.seconds());
            if 0.0 < wait && self.steps == 0 {
                rest = Rest::Until(wait);
            } else {
                self.dance();
            }
        } else if !(self.is_stale && self.outbox.is_empty()) {
            // A picture that nobody has taken is looked after again soon.
            rest = if self.is_stale {
                Rest::Until(0.02)
            } else {
                Rest::Called
            };
        }
        self.show();
        rest
    }

    fn may_dance(&self) -> bool {
        let stands = |(show, _): &(Show, _)| show.stopped().is_none();
        (self.plays || 0 < self.steps) && self.stage.as_ref().is_some_and(stands)
    }

    /// Takes in everything that was sent; of many designs only the last counts.
    fn obey(&mut self, inputs: &Receiver<Input>) {
        let mut wish = None;
        loop {
            match inputs.try_recv() {
                Ok(Input::Wanted(Command::Wish(design))) => wish = Some(design),
                Ok(input) => {
                    if let Some(design) = wish.take() {
                        self.wish(*design);
                    }
                    self.take_in(input);
                }
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => {
                    self.quits = true;
                    break;
                }
            }
        }
        if let Some(design) = wish {
            self.wish(*design);
        }
    }

    /// Takes in one thing that was sent.
    pub(crate) fn take_in(&mut self, input: Input) {
        match input {
            Input::Wanted(command) => self.follow(command),
            Input::Sewn(sewn) => self.dress(*sewn),
        }
    }

    fn follow(&mut self, command: Command) {
        match command {
            Command::Play => {
                self.plays = true;
                self.restart_clock();
            }
            Command::Pause => {
                self.plays = false;
                self.is_stale = true;
            }
            Command::Step => {
                self.plays = false;
                self.steps += 1;
            }
            Command::Speed(speed) => {
                self.speed = speed;
                self.restart_clock();
            }
            Command::Wish(design) => self.wish(*design),
            Command::Reset => self.reset(),
            Command::Pull(pull) => {
                if let Some((show, _)) = &mut self.stage
                    && let Err(error) = show.pull(pull)
                {
                    let kept = show.design().clone();
                    self.refuse(Sentence::of(&error), kept);
                }
            }
            Command::Watch(watch) => {
                self.watch = watch;
                self.is_stale = true;
            }
            Command::Quit => self.quits = true,
        }
    }

    fn restart_clock(&mut self) {
        self.pace.set_speed(self.clock.seconds(), self.speed);
        self.is_stale = true;
    }

    fn wish(&mut self, design: Design) {
        if self.sewing.is_some() {
            if let Some(sewing) = &self.sewing {
                sewing.call_off();
            }
            self.next = Some(design);
            return;
        }
        let Some((show, clothes)) = &mut self.stage else {
            self.resew(design);
            return;
        };
        let prints_anew = !show.design().prints().eq(design.prints());
        let set_anew = Scenery::of(&show.design().stage) != Scenery::of(&design.stage);
        let before = (show.design().clone(), show.production());
        match show.wish(&design) {
            Ok(Wish::Resew) => self.resew(design),
            Ok(Wish::Granted) => {
                self.is_stale = true;
                let adorned_anew = !Arc::ptr_eq(&before.1, &show.production());
                if prints_anew || set_anew || adorned_anew {
                    match wardrobe(&design, &show.production()) {
                        Ok(new) => *clothes = new,
                        Err(sentence) => self.refuse(sentence, before.0),
                    }
                }
            }
            Err(error) => self.refuse(Sentence::of(&error), before.0),
        }
    }

    fn refuse(&self, sentence: Sentence, kept: Design) {
        self.outbox.say(News::Refused(sentence, Box::new(kept)));
    }

    fn sew(&mut self, design: Design, entrance: Entrance) {
        self.outbox.say(News::Sewing);
        let on_stage = self.stage.as_ref().map(|(show, _)| show.design());
        self.sewing = Sewing::begin((design, entrance), on_stage, &self.inputs, &*self.outbox);
    }

    /// Sews anew while what is on stage dances on.
    fn resew(&mut self, design: Design) {
        let entrance = if self.stage.is_some() {
            Entrance::Settled
        } else {
            Entrance::Settling
        };
        self.sew(design, entrance);
    }

    /// Puts what was sewn on stage, or sews what was wished meanwhile.
    fn dress(&mut self, sewn: Sewn) {
        self.sewing = None;
        if let Some(next) = self.next.take() {
            // Back at what is on stage, nothing needs to be sewn.
            if self.stage.is_some() {
                self.wish(next);
            } else {
                self.resew(next);
            }
            if self.sewing.is_none() {
                self.outbox.say(News::Sewn);
            }
            return;
        }
        match sewn.show {
            Ok(Some(stage)) => {
                self.stage = Some(stage);
                self.repair = Repair::default();
                self.samples.clear();
                self.outbox.say(News::Sewn);
            }
            Ok(None) => self.outbox.say(News::Sewn),
            Err(sentence) => {
                let kept =
                    (self.stage.as_ref()).map_or(sewn.design, |(show, _)| show.design().clone());
                self.refuse(sentence, kept);
            }
        }
        self.restart_clock();
    }

    fn reset(&mut self) {
        let Some((show, _)) = &mut self.stage else {
            return;
        };
        match show.restarted() {
            Ok(fresh) => {
                *show = fresh;
                self.samples.clear();
            }
            Err(error) => {
                let kept = show.design().clone();
                self.refuse(Sentence::of(&error), kept);
            }
        }
        self.restart_clock();
    }

    /// One frame.
    fn dance(&mut self) {
        let Some((show, _)) = &mut self.stage else {
            return;
        };
        let repairs = match show.design().method.uncrossed {
            Uncrossed::Always => true,
            // A single frame takes the time that it needs.
            Uncrossed::InTime => 0 < self.steps || self.repair.is_on(),
            Uncrossed::Never => false,
        };
        show.set_crossings(if repairs {
            Crossings::Repair
        } else {
            Crossings::Leave
        });
        let started = self.clock.seconds();
        self.pace.begin(started);
        self.steps = self.steps.saturating_sub(1);
        let result = match &self.pool {
            Some(pool) => pool.install(|| show.advance()),
            None => show.advance(),
        };
        if result.is_err() {
            self.steps = 0;
        }
        let cost = self.clock.seconds() - started;
        if repairs == self.repair.is_on() {
            self.repair.note(cost, self.pace.period());
        }
        #[expect(
            clippy::cast_possible_truncation,
            reason = "seven digits of a millisecond are enough"
        )]
        let milliseconds = (cost * 1e3) as f32;
        if self.samples.len() < MOST_SAMPLES {
            self.samples.push(Sample {
                time: show.time(),
                milliseconds,
                vitals: show.vitals(),
            });
        }
        self.is_stale = true;
    }

    /// Hands out a snapshot where the last one was taken and something is new.
    fn show(&mut self) {
        if !self.is_stale || !self.outbox.is_empty() {
            return;
        }
        let pace = if self.may_dance() {
            self.pace.measured()
        } else {
            None
        };
        let samples = std::mem::take(&mut self.samples);
        if let Some((show, clothes)) = &self.stage {
            let mut snapshot = photograph(show, clothes, self.watch);
            (snapshot.samples, snapshot.pace) = (samples, pace);
            if self.watch.sunken {
                let now = self.clock.seconds();
                if SUNKEN_INTERVAL < now - self.sunken.0 || !self.plays {
                    // Cloth meets her skin, which is not drawn.
                    let (mut positions, mut normals) = (Vec::new(), Vec::new());
                    let skin = &show.production().dancer.skin;
                    skin.pose(show.world_from_bind(), &mut positions, &mut normals);
                    self.sunken = (now, show.sunken(&positions, &normals));
                }
                snapshot.sunken.clone_from(&self.sunken.1);
            }
            self.outbox.post(snapshot);
            self.is_stale = false;
        }
    }
}

/// The first moment of a design's show.
#[cfg(test)]
pub(crate) fn first_moment(design: &Design) -> Result<Snapshot, Sentence> {
    let said = |error: lole_stage::StageError| Sentence::of(&error);
    let production = Arc::new(lole_stage::Production::new(design).map_err(said)?);
    let clothes = wardrobe(design, &production)?;
    let show = Show::of(production).map_err(said)?;
    Ok(photograph(&show, &clothes, Watch::default()))
}

/// The show as it stands.
fn photograph(show: &Show, clothes: &Arc<Wardrobe>, watch: Watch) -> Snapshot {
    let production = &*show.production();
    let now = (production.design.stage.gaze, show.time());
    let bones = show.world_from_bind();
    let soon = show.bones_after(lole_picture::alive::EYES_LEAD);
    let expression = lole_picture::alive::expression_at(&production.dancer, now, [bones, &soon]);
    let body = lole_picture::drawn_body(&production.dancer, bones, (expression, &show.swing()));
    Snapshot {
        wardrobe: Arc::clone(clothes),
        time: show.time(),
        particles: show.particles().to_vec(),
        moment: Moment::new(production, show.surfaces(), body),
        capsules: show.capsules().to_vec(),
        bones: show.bones(),
        strain: if watch.strain {
            show.strain()
        } else {
            Vec::new()
        },
        sunken: Vec::new(),
        samples: Vec::new(),
        pace: None,
        part: show.part(),
        recording_seconds: show.recording_seconds(),
        substep_count: show.substep_count(),
        without_room: show.without_room(),
        stopped: show.stopped(),
    }
}
