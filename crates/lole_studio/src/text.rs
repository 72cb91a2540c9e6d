//! Every word of the window, in both languages.

use lole_costume::document::{MethodName, Uncrossed};
use lole_language::{Words, words};

pub(crate) const OPEN: Words = words("開く…", "Open…");
pub(crate) const SAVE: Words = words("保存", "Save");
pub(crate) const SAVE_AS: Words = words("名前をつけて保存…", "Save as…");
pub(crate) const PICTURE: Words = words("写真を撮る…", "Take a picture…");
pub(crate) const BROWSE: Words = words("パソコンのファイル選択で探す…", "The system’s own window…");
pub(crate) const TIMELINE_HOW: Words = words(
    "色の札を左右に引くと順番が変わります。押すと、その所が下に出ます。",
    "Drag a block to change the order; click it to see that part below.",
);
pub(crate) const REPEAT_PART: Words = words("選んだ所をもう一度", "Repeat the chosen part");
pub(crate) const MIRROR_PARTS: Words = words("左右を入れかえる", "Mirror left and right");
pub(crate) const PLACES: Words = words("場所", "Places");
pub(crate) const OWN_FOLDER: Words = words("自分のフォルダー", "My folder");
pub(crate) const FOLDER_ABOVE: Words = words("上のフォルダーへ", "To the folder above");
pub(crate) const NOTHING_HERE: Words = words(
    "ここには選べるファイルがありません。",
    "There is nothing to choose here.",
);
pub(crate) const OPEN_FOLDER: Words = words("フォルダーを開く", "Open the folder");
pub(crate) const MAKE_THEM: Words = words("作る・印刷する", "Make and print");
pub(crate) const WHAT_TO_MAKE: Words = words("何を作りますか？", "What shall it be?");
pub(crate) const FIRST_PAGE: Words = words("最初のページ", "First page");
pub(crate) const RECENT: Words = words("最近のデザイン", "Recent designs");
pub(crate) const OPEN_DESIGN: Words = words("デザインを開く…", "Open a design…");
pub(crate) const BEGIN_AS_IT_IS: Words = words("このまま始める", "Begin as it is");
pub(crate) const TRY_ON: Words = words("この人に着せて見る", "See it on her");
pub(crate) const WAITS: Words = words("順番を待っています", "Waiting");
pub(crate) const STOPPING: Words = words("やめています…", "Stopping…");
pub(crate) const CALLED_OFF: Words = words(
    "やめました。何も書いていません。",
    "Called off; nothing was written.",
);
pub(crate) const REPLACE: Words = words("上書きする", "Replace it");
pub(crate) const CANCEL: Words = words("やめる", "Cancel");
pub(crate) const CLOSE: Words = words("閉じる", "Close");
pub(crate) const FILE: Words = words("ファイル", "File");
pub(crate) const UNDO: Words = words("元に戻す", "Undo");
pub(crate) const REDO: Words = words("やり直す", "Redo");
pub(crate) const RESUME: Words = words("続きから", "Go on with it");
pub(crate) const DISCARD: Words = words("捨てる", "Throw it away");
pub(crate) const UNNAMED: Words = words("名前のないデザイン", "Untitled design");
pub(crate) const CHANGED: Words = words("（未保存）", "(not saved)");

pub(crate) const PLAY: Words = words("踊る", "Play");
pub(crate) const PAUSE: Words = words("止める", "Pause");
pub(crate) const STEP: Words = words("1コマずつ", "One frame");
pub(crate) const RESET: Words = words("最初から", "From the start");
pub(crate) const SEE_AGAIN: Words = words("見直す", "See again");
pub(crate) const SEE_PART_AGAIN: Words = words("この所を見直す", "See the chosen part again");
pub(crate) const FRAME_BEFORE: Words = words("1コマ前", "One frame back");
pub(crate) const FRAME_AFTER: Words = words("1コマ先", "One frame on");
pub(crate) const PHRASE_FROM: Words = words("ここから", "From here");
pub(crate) const PHRASE_TO: Words = words("ここまで", "To here");
pub(crate) const PHRASE_ALL: Words = words("全部", "All of it");
pub(crate) const KEEP_BESIDE: Words = words("隣に並べてくらべる", "Keep beside, to compare");
pub(crate) const WHO_IS_BESIDE: Words = words(
    "正面から見て、左がいま、右が取っておいた踊りです。",
    "Seen from the front: now on the left, the kept dance on the right.",
);
pub(crate) const NOBODY_BESIDE: Words = words("並べるのをやめる", "Stop comparing");
pub(crate) const DANCE_ON: Words = words("踊りに戻る", "Back to the dance");
pub(crate) const SPEED: Words = words("速さ", "Speed");
pub(crate) const PACE: Words = words("踊りの速さ", "Pace of the dance");

pub(crate) const FILES: Words = words("ファイル ▾", "File ▾");
pub(crate) const LARGER_TYPE: Words = words("字を大きく", "Larger type");
pub(crate) const SMALLER_TYPE: Words = words("字を小さく", "Smaller type");
pub(crate) const SIZE_OF_TYPE: Words = words(
    "字とボタンの大きさ（Ctrl と ＋・− でも変わります）",
    "Size of letters and buttons (Ctrl with + and −, too)",
);
pub(crate) const MAKES: Words = words("作る", "Make");
pub(crate) const WATCHES: Words = words("踊りを見る", "Watch the dance");
pub(crate) const TABS: Words = words("作る順番", "What to work on");
pub(crate) const RESEARCH: Words = words("研究者向け", "For researchers");
pub(crate) const FOR_RESEARCHERS: Words = words("研究者向け…", "For researchers…");
pub(crate) const COMPUTATION: Words = words("計算のしかた", "Computation");

pub(crate) const DANCE: Words = words("踊り", "Dance");
pub(crate) const DANCE_STEP: Words = words("ステップ", "Step");
pub(crate) const CHOREOGRAPHY: Words = words("振付", "Choreography");
pub(crate) const RECORDING: Words = words("踊りの記録", "Recorded dance");
pub(crate) const RECORDING_SHORT: Words = words("記録", "Recording");
pub(crate) const PICTURES: Words = words("写真と動画", "Pictures and film");
pub(crate) const SET: Words = words("背景と光", "Background and light");
pub(crate) const FORMATION_OF_PART: Words = words("グループの隊形", "formation of the group");
pub(crate) const FORMATION_STAYS: Words = words("隊形はそのまま", "formation as before");
pub(crate) const FORMATION: Words = words("並び方", "How they stand");
pub(crate) const TITLE: Words = words("動画の題名", "Title of the film");
pub(crate) const TITLE_HINT: Words = words("なくてもかまいません", "may be left empty");
pub(crate) const MOTION_BLUR: Words = words("動きのぼけ", "Motion blur of the film");
pub(crate) const MOOD_STAYS: Words = words("照明はそのまま", "lamps as before");
pub(crate) const MOOD: Words = words("照明の気分", "Mood of the lamps");
pub(crate) const ALTERATIONS: Words = words("仮縫いのあとの補正", "Alterations after a trial");
pub(crate) const WHY_ALTER: Words = words(
    "ブラウス・ムウムウ・ホロクーの型紙を引き直します。見えたしわの所に、つまんだ（足した）長さを入れてください",
    "Blouse, muʻumuʻu and holokū are drafted anew. Where you see such creases, give the length that was pinned out or filled in",
);
pub(crate) const NO_ALTERATIONS: Words = words("補正をやめる", "Without alterations");
pub(crate) const HEAD: Words = words("顔と髪", "Face and hair");
pub(crate) const AGE: Words = words("年齢", "Age");
pub(crate) const NO_AGE: Words = words("年齢を書かない", "Leave the age out");
pub(crate) const YEARS: Words = words(" 歳", " years");
pub(crate) const OTHER_FACE: Words = words("別の顔にする", "Another face");
pub(crate) const MEASURED_FACE: Words = words("もとの顔に戻す", "The measured face");
pub(crate) const FEATURES: Words = words("顔立ち", "Features");
pub(crate) const HAIR: Words = words("髪型", "Hair");
pub(crate) const MAKEUP: Words = words("化粧", "Makeup");
pub(crate) const GAZE: Words = words("視線", "Where she looks");
pub(crate) const CAMERA: Words = words("動画の撮り方", "Camera of the film");
pub(crate) const SCHOOL: Words = words("流儀（ハーラウ）", "Manner (hālau)");
pub(crate) const ADD_PART: Words = words("＋ 部分を足す", "+ Add a part");
pub(crate) const MOVE_UP: Words = words("上へ", "up");
pub(crate) const MOVE_DOWN: Words = words("下へ", "down");
pub(crate) const REMOVE: Words = words("消す", "remove");
pub(crate) const FEWER_COUNTS: Words = words("拍を減らす", "fewer counts");
pub(crate) const MORE_COUNTS: Words = words("拍を増やす", "more counts");
pub(crate) const COUNTS: Words = words("拍", "counts");
pub(crate) const FIRST_SIDE: Words = words("どちらから始めるか", "which side begins");
pub(crate) const FROM_RIGHT: Words = words("右から", "right");
pub(crate) const FROM_LEFT: Words = words("左から", "left");
pub(crate) const FACING: Words = words("体の向き", "facing");
/// In the order of the choreography's directions, as the dancer has them.
pub(crate) const DIRECTIONS: [Words; 8] = [
    words("右後ろ向き", "right back"),
    words("右向き", "right"),
    words("右前向き", "right front"),
    words("正面", "front"),
    words("左前向き", "left front"),
    words("左向き", "left"),
    words("左後ろ向き", "left back"),
    words("後ろ向き", "back"),
];
pub(crate) const CHOREOGRAPHY_HOW: Words = words(
    "ステップを順に並べて、一曲分の振付を作れます。",
    "Steps are put one after the other, to a whole dance.",
);
pub(crate) const DANCE_CHOREOGRAPHY: Words = words("振付で踊る", "Dance a choreography");
pub(crate) const RECORDING_HOW: Words = words(
    "モーションキャプチャなどで記録した動き（BVH・VRMA・glTF）で踊れます。",
    "A dance that was recorded (BVH, VRMA, glTF) can be danced.",
);
pub(crate) const OPEN_FIRST_RECORDING: Words = words("踊りの記録を開く…", "Open a recording…");
pub(crate) const OPEN_RECORDING: Words = words("ほかの記録を開く…", "Open another recording…");
pub(crate) const CLIP: Words = words("どの動きを踊るか", "Which of its dances");
pub(crate) const AFTER_ITS_END: Words = words("終わったら", "At its end she");
pub(crate) const STANDS_STILL: Words = words("止まる", "stands still");
pub(crate) const BEGINS_AGAIN: Words = words("くり返す", "begins again");
pub(crate) const WAY: Words = words("場所", "Over the floor she");
pub(crate) const WALKS: Words = words("進む", "goes her way");
pub(crate) const STAYS: Words = words("その場にいる", "stays");
pub(crate) const DROP_RECORDING: Words = words(
    "BVH・VRMA のファイルを窓に落としても踊れます。",
    "A BVH or VRMA file dropped on the window is danced, too.",
);
pub(crate) const TEMPO: Words = words("テンポ", "Tempo (counts)");
pub(crate) const TEMPO_UNIT: Words = words(" 拍/分", " /min");

pub(crate) const CLOTH: Words = words("布と柄", "Cloth");
pub(crate) const NO_CLOTH_WORN: Words = words(
    "いま着ているものに、布で作るものはありません。",
    "Nothing that is worn is made of cloth.",
);
pub(crate) const METHOD: Words = words("計算方法", "Method");
pub(crate) const UNCROSSED: Words = words("布どうしを通り抜けさせない", "Cloth stays out of cloth");
pub(crate) const STIFFNESS: Words = words("かたさ（倍）", "Stiffness (times)");
pub(crate) const DAMPING: Words = words("空気の抵抗", "Damping by air");
pub(crate) const BODY: Words = words("体", "Body");
pub(crate) const WIND: Words = words("風", "Wind");
pub(crate) const STILL_AIR: Words = words("無風", "still");
pub(crate) const BREEZE: Words = words("そよ風", "breeze");
pub(crate) const STRONG_WIND: Words = words("強い風", "strong");
pub(crate) const WIND_SPEED: Words = words("風の速さ", "Speed of the wind");
pub(crate) const WIND_ACTS_ON: Words = words("風の当たり方", "The wind acts on");
pub(crate) const WIND_ON_FACES: Words = words("布の面に", "faces of the cloth");
pub(crate) const WIND_ON_ALL: Words = words("どこも同じ", "all alike");
pub(crate) const WIND_DIRECTION: Words = words("風の吹き方", "The wind");
pub(crate) const WIND_IS_STEADY: Words = words("一方から", "blows one way");
pub(crate) const WIND_COMES_FROM: Words = words(
    "どちらから吹くか（画面で）",
    "It comes from (in the picture)",
);
pub(crate) const WIND_FROM_LEFT: Words = words("左", "the left");
pub(crate) const WIND_FROM_FRONT: Words = words("手前", "the front");
pub(crate) const WIND_FROM_RIGHT: Words = words("右", "the right");
pub(crate) const WIND_FROM_BACK: Words = words("奥", "behind");
pub(crate) const WIND_ANGLE: Words = words("風の角度", "Angle of the wind");
pub(crate) const WIND_TURNS: Words = words("回る", "turns round");
pub(crate) const WIND_TO_AND_FRO: Words = words("行き来する", "to and fro");
pub(crate) const GUSTS: Words = words("風のむら", "Gusts");
pub(crate) const OTHER_GUSTS: Words = words("ちがうむらにする", "Other gusts");
pub(crate) const MEETS_SKIN: Words = words("布が肌そのものに触れる", "Cloth meets the skin itself");
pub(crate) const CAPSULES_COUNT: Words = words("体のカプセルの数", "Capsules of the body");

pub(crate) const COSTUME: Words = words("衣装", "Costume");
pub(crate) const FABRIC: Words = words("布", "Fabric");
pub(crate) const PRINT: Words = words("柄", "Print");
pub(crate) const COLORWAY: Words = words("配色", "Colors");
pub(crate) const GROUND: Words = words("地の色", "Ground color");
pub(crate) const WEAR_SKIRT: Words = words("パウスカートをはく", "Wear the pāʻū skirt");
pub(crate) const ELASTIC_ROWS: Words = words("ゴムの段数", "Rows of elastic");
pub(crate) const ELASTIC_PLACES: Words = words("ゴムの位置と幅", "Where the elastic is");
pub(crate) const RUFFLE_ABOVE: Words =
    words("いちばん上のゴムから上のフリル", "Ruffle above the top row");
pub(crate) const CASING: Words = words("ゴム通しの幅", "Height of a casing");
pub(crate) const CASING_GAP: Words = words("ゴム通しの間隔", "Between two casings");
pub(crate) const WORN_ON_HIP_BONES: Words = words(
    "いちばん下のゴムを腰骨に合わせる",
    "Lowest row on the hip bones",
);
pub(crate) const WORN_HEIGHT: Words =
    words("いちばん下のゴム（床から）", "Lowest row, above the floor");
pub(crate) const ADD_GARMENT: Words = words("＋ 服や小物を足す", "+ Add a garment");
pub(crate) const ORDER_OF_LAYERS: Words = words("重ねる順（上が内側）", "Order (inner first)");
pub(crate) const MOVE_IN: Words = words("内側へ:", "Move inward:");
pub(crate) const MOVE_OUT: Words = words("外側へ:", "Move outward:");
pub(crate) const NO_MORE_DANCED: Words = words(
    "踊らせる服は 4 着までです。ほかの服は足せます。",
    "Four garments dance at most; others can still be added.",
);
pub(crate) const SHAPE: Words = words("形と寸法", "Shape and measures");
pub(crate) const BY_MEASURES: Words = words("採寸に合わせる", "by the measures");
pub(crate) const CLOTH_WIDTH: Words = words("布幅（耳から耳まで）", "Width, selvage to selvage");

pub(crate) const PLACEMENT: Words = words("柄の大きさと置き方", "Size and place of the print");
pub(crate) const OWN_PICTURE: Words = words("自分の布の写真や絵を使う…", "Use a photo or picture…");
pub(crate) const DROP_PICTURE: Words = words("絵をやめる", "leave the picture out");
pub(crate) const OWN_PICTURE_MARKS: Words = words("自分の布の写真と印", "Photo with its marks");
pub(crate) const MARK_REPEAT: Words = words("ひと送りを囲む", "Frame the repeat");
pub(crate) const MARK_LENGTH: Words = words("長さを測る", "Mark a length");
pub(crate) const MARK_REPEAT_HOW: Words = words(
    "写真の上で、くり返す柄ひとつ分を斜めになぞって囲みます。",
    "Drag over one repeat of the print, from corner to corner.",
);
pub(crate) const MARK_LENGTH_HOW: Words = words(
    "定規など長さのわかるものを端から端までなぞり、下に長さを入れます。",
    "Drag along something whose length you know, such as a ruler, and give its length below.",
);
pub(crate) const KNOWN_LENGTH: Words = words("なぞった長さ", "Length of the line");
pub(crate) const FORGET_MARKS: Words = words("印を消す", "Forget the marks");
pub(crate) const PICTURE_NOT_READ: Words = words(
    "この絵はまだ読めていません。",
    "This picture could not be read.",
);
pub(crate) const REPEAT: Words = words("柄のひと送りの幅", "Width of one repeat");
pub(crate) const PRINT_SCALE: Words = words("柄の大きさ（倍）", "Size of the print (times)");
pub(crate) const PRINT_DIRECTION: Words = words(
    "柄の上が向くほう（布を横に置いて）",
    "Top of the print, the bolt lying sideways",
);
pub(crate) const BORDER: Words = words("ボーダー柄", "Border print");
pub(crate) const ALL_OVER: Words = words("ない（総柄）", "none: all over");
pub(crate) const BORDER_HEM: Words = words("ボーダーをすそに", "border at the hem");
pub(crate) const BORDER_HIP: Words = words("ボーダーを腰に", "border at the hips");
pub(crate) const FLIP: Words = words("裏返し", "Mirror image");
pub(crate) const NOT_FLIPPED: Words = words("しない", "no");
pub(crate) const FLIP_SIDEWAYS: Words = words("左右に", "left and right");
pub(crate) const FLIP_OVER: Words = words("上下に", "top and bottom");
pub(crate) const TILING: Words = words("柄の並べ方", "Repeat");
pub(crate) const STRAIGHT: Words = words("まっすぐ", "straight");
pub(crate) const HALF_DROP: Words = words("1 列おきに半分下げる", "half drop");
pub(crate) const BRICK: Words = words("1 段おきに半分ずらす", "brick");
pub(crate) const MIRROR: Words =
    words("裏返して並べる（つなぎ目を隠す）", "mirrored (hides edges)");
pub(crate) const OFFSET_ALONG: Words = words("柄を右へずらす", "Print moved to the right");
pub(crate) const OFFSET_ACROSS: Words = words("柄を上へずらす", "Print moved up");

pub(crate) const OWN_FABRIC: Words = words("布幅・自分の布を測る", "Width; test your own cloth");
pub(crate) const OWN_FABRIC_NOW: Words = words("自分の布: ", "Your own cloth: ");
pub(crate) const SWATCH_HOW: Words = words(
    "四角い布の大きさと重さを測ります。次に、幅 3 cm の細い布を机の端から物差しごと押し出し、はみ出した長さの半分ほど下がったところで、はみ出した長さと、先が下がった長さを測ります。",
    "Measure and weigh a rectangle of the cloth. Then push a strip 3 cm wide over a table’s edge, a ruler on top, until its tip has come down by about half of what hangs over; measure how much hangs over and how far the tip is below the table.",
);
pub(crate) const SWATCH_NAME: Words = words("布の名前", "Its name");
pub(crate) const SWATCH_LENGTH: Words = words("耳に沿った長さ", "Length along the selvage");
pub(crate) const SWATCH_WIDTH: Words = words("幅", "Width");
pub(crate) const SWATCH_MASS: Words = words("重さ", "Weight");
pub(crate) const OVERHANG: Words = words("たて: はみ出した長さ", "Along: overhang");
pub(crate) const DROP: Words = words("たて: 下がった長さ", "Along: drop of the tip");
pub(crate) const ALSO_ACROSS: Words = words("よこの布でも測った", "Also tried across");
pub(crate) const OVERHANG_ACROSS: Words = words("よこ: はみ出した長さ", "Across: overhang");
pub(crate) const DROP_ACROSS: Words = words("よこ: 下がった長さ", "Across: drop of the tip");
pub(crate) const TAKE_FABRIC: Words = words("この布で縫う", "Sew from this cloth");

pub(crate) const CUT_AND_COST: Words = words("型紙", "Pattern");
pub(crate) const CUT_PLAN: Words = words("裁ち方図", "Cut plan");
pub(crate) const DRAFTING: Words = words("製図しています…", "Drafting…");
pub(crate) const SINGLE: Words = words("布を一重に", "Cloth single");
pub(crate) const FOLDED: Words = words("二つ折りに", "Folded");
pub(crate) const MATCH_PRINT: Words = words("縫い目で柄を合わせる", "Match the print at seams");
pub(crate) const JOINED: Words = words(
    "布幅より広い部分は、分けて裁ち、目立たないところではぎ合わせます。作り方の最初に書いてあります。",
    "What is wider than this cloth is cut in parts and joined where it does not show: see the first step.",
);
pub(crate) const NO_CLOTH: Words = words("布は使いません。", "No cloth is needed.");
pub(crate) const LARGER: Words = words("大きく見る", "Show it large");
pub(crate) const SELVAGE: Words = words("耳", "selvage");
pub(crate) const FOLD_OF_CLOTH: Words = words("わ", "fold");
pub(crate) const BORDER_SELVAGE: Words = words("耳・ボーダー柄", "selvage with the border");

pub(crate) const COST: Words = words("費用", "Cost");
pub(crate) const YEN: Words = words("円（¥）", "Yen (¥)");
pub(crate) const DOLLAR: Words = words("ドル（$）", "Dollars ($)");
pub(crate) const CLOTH_OF: Words = words("の布", ": cloth");
pub(crate) const PER_METER: Words = words("/ 1 m", "per m");
pub(crate) const PER_YARD: Words = words("/ ヤード", "per yd");
pub(crate) const BY_METER: Words = words("1 m の値段", "Price per meter");
pub(crate) const BY_YARD: Words = words("1 ヤードの値段", "Price per yard");
pub(crate) const PER_SPOOL: Words = words("/ 1 巻き", "per spool");
pub(crate) const PER_COSTUME: Words = words("/ 1 着", "per costume");
pub(crate) const PER_HOUR: Words = words("/ 1 時間", "per hour");
pub(crate) const ELASTIC: Words = words("ゴム", "Elastic");
pub(crate) const TAPE_AND_CORD: Words = words("テープ・ひも", "Tape and cord");
pub(crate) const THREAD: Words = words("糸", "Thread");
pub(crate) const ALL_ELSE: Words = words("そのほか", "All else");
pub(crate) const WAGE: Words = words("縫い手間", "Sewing");
pub(crate) const BOUGHT: Words = words("買うときの値段", "Bought ready");
pub(crate) const PRICE_HINT: Words = words("値段", "price?");
pub(crate) const OPTIONAL: Words = words("任意", "optional");
pub(crate) const NO_PRICE: Words = words(
    "数字で書いてください（例: 1200）。",
    "Write a number, such as 12.50.",
);
pub(crate) const PRICE_ASKED: Words = words("値段を確認", "ask the price");
pub(crate) const TOTAL: Words = words("合計", "Total");
pub(crate) const TOTAL_KNOWN: Words = words("わかっている分", "Known so far");

pub(crate) const GROUP_ORDER: Words = words("全員分", "Group");
pub(crate) const CHOOSE_LIST: Words = words("名簿を選ぶ…", "Choose a list…");
pub(crate) const LIST_HOW: Words = if cfg!(target_arch = "wasm32") {
    words(
        "表計算で 1 行に 1 人、名前・身長・ヒップなどを書き、CSV で保存した名簿を選びます。",
        "Choose a list saved as CSV by a spreadsheet: one dancer a row, with name, stature, hip and so on.",
    )
} else {
    words(
        "表計算で 1 行に 1 人、名前・身長・ヒップなどを書いた名簿（.xlsx .ods .csv）を選びます。",
        "Choose a list from a spreadsheet (.xlsx, .ods, .csv): one dancer a row, with name, stature, hip and so on.",
    )
};
pub(crate) const NAME: Words = words("名前", "Name");
pub(crate) const SPARE: Words = words("予備の布", "Spare cloth");
pub(crate) const PAPER: Words = words("印刷する紙", "Paper");
pub(crate) const KNOWS_BOLT: Words = words("一反の長さで分ける", "Divide among bolts");
pub(crate) const BOLT: Words = words("一反の長さ", "Length of a bolt");
pub(crate) const WORK_OUT: Words = words("全員分を計算する", "Work out what all need");
pub(crate) const MAKE_ORDER: Words = words("注文書のフォルダーを作る…", "Make the order’s folder…");
pub(crate) const ORDER_HOW: Words = words(
    "一覧・買い物・名札（order.pdf）、縫い方の本（booklet.pdf）、データ（order.json）ができます。",
    "Writes the summary, shopping list and labels (order.pdf), the sewing booklet (booklet.pdf) and the data (order.json).",
);
pub(crate) const ORDER_PICTURES: Words = words(
    "踊り手の絵を入れる（1 人に数秒）",
    "Pictures of the dancers (some seconds each)",
);
pub(crate) const TOTALS_ARE_OLD: Words = words(
    "そのあとデザインが変わりました。もう一度計算してください。",
    "The design has changed since; work it out again.",
);
pub(crate) const NO_PRICES_YET: Words = words(
    "値段がまだありません。「型紙」に書いてください。",
    "No prices yet: write them under “Pattern”.",
);
pub(crate) const FOLDER: Words = words("フォルダー", "Folder");

pub(crate) const GARMENTS: Words = words("重ねる服・レイ・小物", "Worn with it");
pub(crate) const TAKE_OFF: Words = words("脱ぐ:", "Take off:");
pub(crate) const UNDER_SKIRT: Words = words("スカートの下", "under the skirt");
pub(crate) const OVER_SKIRT: Words = words("スカートの上", "over it");

pub(crate) const DANCER: Words = words("踊り手", "Dancer");
pub(crate) const TAPE: Words = words("採寸", "Measures");
pub(crate) const TAPE_HINT: Words = words(
    "数字を押して書きます。薄い字は推定です。",
    "Click a number to write it. Pale ones are estimated.",
);
pub(crate) const FOR_PATTERNS: Words = words("体に合わせる服の寸法", "Measures for fitted clothes");
pub(crate) const FOR_PATTERNS_HINT: Words = words(
    "型紙だけが変わります。書かなければ、できた体から推定します。",
    "Patterns alone change. What is left out is estimated from her body.",
);
pub(crate) const FIGURE_BY_STATURE: Words = words("身長から", "by height");
pub(crate) const WOMAN: Words = words("女性", "woman");
pub(crate) const MAN: Words = words("男性", "man");
pub(crate) const CHILD: Words = words("子ども", "child");
pub(crate) const ESTIMATED: Words = words("推定", "estimated");
pub(crate) const LEAVE_OUT: Words = words("推定に戻す", "estimate it");

pub(crate) const SKIRT: Words = words("スカート", "Skirt");
pub(crate) const GATHER: Words = words("ギャザー（ヒップの何倍）", "Gathers (times the hips)");
pub(crate) const HEM: Words = words("すその高さ（床から）", "Hem above the floor");
pub(crate) const SEWS_ANEW: Words = words(
    "変えると縫い直します。縫っている間も踊りは続きます。",
    "A change is sewn anew; the dance goes on meanwhile.",
);
pub(crate) const SEWING: Words = words("縫っています…", "Sewing…");

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
pub(crate) const STRAIN: Words = words(
    "布が引っぱられている所を色で見る",
    "Color the cloth where it pulls",
);
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

/// When cloth is kept from passing through itself.
pub(crate) const fn uncrossed(when: Uncrossed) -> Words {
    match when {
        Uncrossed::Always => words("いつでも", "always"),
        Uncrossed::InTime => words("間に合うあいだだけ", "while there is time"),
        Uncrossed::Never => words("しない", "never"),
    }
}
