//! When every count of a dance falls: a metronome for the music.

use lole_body::Side;
use lole_hula::Count;

/// `counts.csv`: a line for each count: when it falls, what is danced, how fast.
#[must_use]
pub fn counts_csv(counts: &[Count]) -> String {
    let mut text = String::from("time_s,count,part,step,name,side,tempo_bpm\n");
    for count in counts {
        let part = count.part.map_or_else(String::new, |part| part.to_string());
        let (step, name) = count.step.map_or(("", ""), |step| (step.id(), step.name()));
        let side = match (count.step, count.side) {
            (None, _) => "",
            (_, Side::Right) => "right",
            (_, Side::Left) => "left",
        };
        // No name has a comma but "kāholo i mua, i hope".
        text.push_str(&format!(
            "{:.3},{},{part},{step},\"{name}\",{side},{:.2}\n",
            count.time, count.number, count.beats_per_minute
        ));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_hula::DanceStep;

    #[test]
    fn counts_are_lines_with_their_times() {
        let count = |part, number, time| Count {
            time,
            part,
            number,
            step: part.map(|_| DanceStep::KaholoForward),
            side: Side::Left,
            beats_per_minute: 80.0,
        };
        let text = counts_csv(&[count(None, 1, 0.0), count(Some(1), 1, 2.25)]);
        assert_eq!(
            text,
            "time_s,count,part,step,name,side,tempo_bpm\n\
             0.000,1,,,\"\",,80.00\n\
             2.250,1,1,kaholo-forward,\"kāholo i mua, i hope\",left,80.00\n"
        );
    }
}
