//! Every word of the window, in both languages.

use lole_costume::document::MethodName;
use lole_language::{Words, words};

pub(crate) const OPEN: Words = words("開く…", "Open…");
pub(crate) const SAVE: Words = words("保存", "Save");
pub(crate) const SAVE_AS: Words = words("名前をつけて保存…", "Save as…");
pub(crate) const PICTURE: Words = words("写真を撮る", "Take a picture");
pub(crate) const BROWSE: Words = words("探す…", "Browse…");
pub(crate) const CANCEL: Words = words("やめる", "Cancel");
pub(crate) const CLOSE: Words = words("閉じる", "Close");
pub(crate) const FILE: Words = words("ファイル", "File");
pub(crate) const UNNAMED: Words = words("名前のないデザイン", "Untitled design");
pub(crate) const CHANGED: Words = words("（未保存）", "(not saved)");

pub(crate) const PLAYBACK: Words = words("再生", "Playback");
pub(crate) const PLAY: Words = words("踊る", "Dance");
pub(crate) const PAUSE: Words = words("止める", "Pause");
pub(crate) const STEP: Words = words("1コマ進む", "One frame");
pub(crate) const RESET: Words = words("最初から", "Reset");
pub(crate) const SPEED: Words = words("速さ", "Speed");
pub(crate) const REAL_TIME: Words = words("実時間", "Real time");

pub(crate) const DANCE: Words = words("踊り", "Dance");
pub(crate) const DANCE_STEP: Words = words("ステップ", "Step");
pub(crate) const TEMPO: Words = words("テンポ", "Tempo (counts)");
pub(crate) const TEMPO_UNIT: Words = words(" 拍/分", " /min");

pub(crate) const CLOTH: Words = words("布", "Cloth");
pub(crate) const METHOD: Words = words("計算方法", "Method");
pub(crate) const STIFFNESS: Words = words("かたさ（倍）", "Stiffness (times)");
pub(crate) const DAMPING: Words = words("空気の抵抗", "Damping by air");
pub(crate) const WIND: Words = words("風", "Wind");
pub(crate) const MEETS_SKIN: Words = words("布を肌そのものに当てる", "Cloth meets the skin itself");
pub(crate) const CAPSULES_COUNT: Words = words("体のカプセルの数", "Capsules of the body");

pub(crate) const SKIRT: Words = words("スカート", "Skirt");
pub(crate) const GATHER: Words = words("ギャザー（倍）", "Gathers (times)");
pub(crate) const HEM: Words = words("すその高さ（床から）", "Hem above the floor");
pub(crate) const SEWS_ANEW: Words = words(
    "変えると縫い直します。そのあいだも踊りは続きます。",
    "A change is sewn anew; the dance goes on meanwhile.",
);
pub(crate) const SEWING: Words = words("縫っています…", "Sewing…");

pub(crate) const VIEW: Words = words("見る向き", "View");
pub(crate) const FRONT: Words = words("正面", "Front");
pub(crate) const SIDE: Words = words("横", "Side");
pub(crate) const BACK: Words = words("後ろ", "Back");
pub(crate) const THREE_QUARTER: Words = words("斜め", "Turned");
pub(crate) const DRAG_DOES: Words = words("ドラッグで", "Dragging");
pub(crate) const HOLDS: Words = words("布をつまむ", "holds the cloth");
pub(crate) const TURNS: Words = words("見る向きを回す", "turns the view");
pub(crate) const HINT: Words = words(
    "ドラッグ：回す・布をつまむ　右ドラッグ：ずらす　ホイール：近づく",
    "Drag: turn, hold cloth · right drag: move · wheel: nearer",
);

pub(crate) const SHOWS: Words = words("重ねて見る", "Show");
pub(crate) const CAPSULES: Words = words("カプセル", "Capsules");
pub(crate) const SPRINGS: Words = words("ばね", "Springs");
pub(crate) const STRAIN: Words = words("伸び縮み", "Strain");
pub(crate) const SUNKEN: Words = words("めり込み", "Penetration");
pub(crate) const SKELETON: Words = words("骨格", "Skeleton");
pub(crate) const SHRUNK: Words = words("縮み", "shrunk");
pub(crate) const STRETCHED: Words = words("伸び", "stretched");

pub(crate) const GRAPHS: Words = words("グラフ", "Graphs");
pub(crate) const FRAME_TIME: Words = words("1コマの計算時間（ミリ秒）", "Frame time (ms)");
pub(crate) const ENERGY: Words = words("エネルギー（J）", "Energy (J)");
pub(crate) const MOTION_ENERGY: Words = words("動き", "motion");
pub(crate) const HEIGHT_ENERGY: Words = words("高さ（最低から）", "height, above its least");
pub(crate) const ELASTIC_ENERGY: Words = words("ばねと曲げ", "springs and bending");
pub(crate) const HEM_PATH: Words = words(
    "すその動き（cm、正面から）",
    "Path of the hem (cm, from the front)",
);

pub(crate) const SETTLING: Words = words("布をなじませています", "The skirt settles");
pub(crate) const SECONDS: Words = words("秒", "s");
pub(crate) const PICTURES_PER_SECOND: Words = words("コマ/秒", "pictures/s");
pub(crate) const MS_PER_FRAME: Words = words("ミリ秒/コマ", "ms/frame");
pub(crate) const OPEN_IT: Words = words("開く", "Open");

/// A word on each method.
pub(crate) const fn method(method: MethodName) -> Words {
    match method {
        MethodName::Xpbd => words("実時間", "real time"),
        MethodName::FbEuler => words("基準、遅い", "reference, slow"),
        MethodName::Euler => words("飛び散りやすい", "flies apart"),
        MethodName::Rk4 => words("古典的、遅い", "classical, slow"),
        MethodName::RkAsPrinted => words("論文の式のまま", "as printed"),
        MethodName::RkDoubleCounted => words("二重に数える", "counted twice"),
    }
}
