//! Where the dance is seen.

/// What is around the dancer in pictures.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct StageDesign {
    /// Floor, background and light.
    pub set: StageSet,
    /// What the lamps of a theater say.
    pub mood: StageMood,
    /// How the film's camera moves.
    pub camera: CameraWork,
    /// How the film sees what moves while the shutter is open.
    pub motion_blur: MotionBlur,
    /// Where she looks.
    pub gaze: Gaze,
    /// What is written over the beginning of a film; nothing where it is empty.
    pub title: String,
}

/// Where the dancer looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Gaze {
    /// At the hand that tells the story.
    #[default]
    Hands,
    /// Ahead, at those who watch.
    Ahead,
}

impl Gaze {
    /// All of them, the usual one first.
    pub const ALL: [Self; 2] = [Self::Hands, Self::Ahead];

    /// Its name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Hands => "hands",
            Self::Ahead => "ahead",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> lole_language::Words {
        use lole_language::words;
        match self {
            Self::Hands => words("手を追う", "at her hands"),
            Self::Ahead => words("まっすぐ前", "straight ahead"),
        }
    }
}

/// How the film's camera moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CameraWork {
    /// Slowly from side to side.
    #[default]
    Drift,
    /// It goes with her and does not turn.
    Still,
    /// Once around her in 12 seconds.
    Turntable,
    /// It stands elsewhere in every phrase of the dance.
    Cuts,
}

impl CameraWork {
    /// All of them, the usual one first.
    pub const ALL: [Self; 4] = [Self::Drift, Self::Still, Self::Turntable, Self::Cuts];

    /// Its name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Drift => "drift",
            Self::Still => "still",
            Self::Turntable => "turntable",
            Self::Cuts => "cuts",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> lole_language::Words {
        use lole_language::words;
        match self {
            Self::Drift => words("ゆっくり左右に", "slowly from side to side"),
            Self::Still => words("正面から", "from the front"),
            Self::Turntable => words("ひとまわり", "once around"),
            Self::Cuts => words("フレーズごとに切り替える", "cut on phrases"),
        }
    }
}

/// How long the shutter of the film's camera is open for each picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MotionBlur {
    /// For a moment: what moves is as sharp as what stands.
    #[default]
    None,
    /// Half of the time from one picture to the next, as films have it: an angle of 180°.
    Film,
    /// All of it: 360°.
    Long,
}

impl MotionBlur {
    /// All of them, the usual one first.
    pub const ALL: [Self; 3] = [Self::None, Self::Film, Self::Long];

    /// Its name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Film => "film",
            Self::Long => "long",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> lole_language::Words {
        use lole_language::words;
        match self {
            Self::None => words("なし", "none"),
            Self::Film => words("映画のように", "as in films"),
            Self::Long => words("長く流す", "long"),
        }
    }

    /// How long the shutter is open, over the time from one picture to the next.
    #[must_use]
    pub const fn open_share(self) -> f32 {
        match self {
            Self::None => 0.0,
            Self::Film => 0.5,
            Self::Long => 1.0,
        }
    }
}

/// What the lamps of a theater say of the song.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StageMood {
    /// Rose and violet.
    #[default]
    Tender,
    /// Gold and coral.
    Joyful,
    /// Blue and green.
    Sea,
    /// Dark, with little but the lamp on her.
    Solemn,
}

impl StageMood {
    /// All of them, the usual one first.
    pub const ALL: [Self; 4] = [Self::Tender, Self::Joyful, Self::Sea, Self::Solemn];

    /// Its name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Tender => "tender",
            Self::Joyful => "joyful",
            Self::Sea => "sea",
            Self::Solemn => "solemn",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> lole_language::Words {
        use lole_language::words;
        match self {
            Self::Tender => words("やさしい(紫)", "tender: violet"),
            Self::Joyful => words("はなやか(金)", "joyful: gold"),
            Self::Sea => words("海(青)", "the sea: blue"),
            Self::Solemn => words("おごそか(暗い)", "solemn: dark"),
        }
    }
}

/// Floor, background and light of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StageSet {
    /// A photographer's studio: sand-colored, without a horizon.
    #[default]
    Studio,
    /// White and even, for catalogues.
    Plain,
    /// A dark stage with lamps from behind and a pool of light.
    Theater,
    /// A beach when the sun goes down.
    Beach,
    /// A lawn before trees and mountains, by day.
    Lawn,
}

impl StageSet {
    /// All of them, the usual one first.
    pub const ALL: [Self; 5] = [
        Self::Studio,
        Self::Plain,
        Self::Theater,
        Self::Beach,
        Self::Lawn,
    ];

    /// Its name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Studio => "studio",
            Self::Plain => "plain",
            Self::Theater => "theater",
            Self::Beach => "beach",
            Self::Lawn => "lawn",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> lole_language::Words {
        use lole_language::words;
        match self {
            Self::Studio => words("写真スタジオ", "studio"),
            Self::Plain => words("白い背景", "plain white"),
            Self::Theater => words("劇場", "theater"),
            Self::Beach => words("夕暮れの浜", "beach at dusk"),
            Self::Lawn => words("芝生と山", "lawn and mountains"),
        }
    }
}
