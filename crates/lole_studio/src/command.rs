//! What the interface asks of the simulation's thread.

use lole_costume::document::Design;
use lole_stage::Pull;

/// One wish.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Dance on.
    Play,
    /// Stand still.
    Pause,
    /// One frame, then stand still.
    Step,
    /// Seconds of the dance in one second on the wall, above 0.
    Speed(f64),
    /// Another design; what can be changed while dancing is.
    Wish(Box<Design>),
    /// From the beginning.
    Reset,
    /// Hold the cloth, or let it go.
    Pull(Option<Pull>),
    /// What is to be worked out for the picture besides the cloth.
    Watch(Watch),
    /// End the thread.
    Quit,
}

/// What costs time and is only worked out where it is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Watch {
    /// Strain at every particle.
    pub strain: bool,
    /// Particles below the drawn skin.
    pub sunken: bool,
}
