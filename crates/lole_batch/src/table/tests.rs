//! Laws of tables: both files say the same, and nothing of a clock.

use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;

use super::*;
use crate::Sweep;

fn rows() -> (Plan, Vec<(Run, Record)>) {
    let text = "lole_sweep = 1\nkind = \"grid\"\n[[axis]]\nkey = \"skirt.gather_ratio\"\nvalues = [2, 3.5]\n\
                [[axis]]\nkey = \"fabric.name\"\nvalues = [\"a, b\", \"\\\"c\\\"\"]\n";
    let plan = Plan::new(Sweep::read(text, "s").unwrap(), "lole = 1\n", "d").unwrap();
    let rows = (0..plan.run_count()).map(|number| {
        let run = plan.run(number, 0);
        let figures = Figures {
            sway_cm: (number == 1).then_some(0.1 + 0.2),
            strain_worst_pct: f64::NAN,
            state_hash: "00ff".to_owned(),
            ..Figures::default()
        };
        let error = (number == 3).then(|| Sentence::new("だめ", "no, \"never\"").into());
        let record = Record {
            lole: "1".to_owned(),
            document: run.document.clone(),
            figures: (number != 3).then_some(figures),
            error,
            process_seconds: number as f64,
        };
        (run, record)
    });
    (plan.clone(), rows.collect())
}

#[test]
fn both_files_say_the_same_of_every_cell() {
    let (plan, rows) = rows();
    let table = Table::new(&plan, &rows);
    let csv = table.to_csv();
    assert_eq!(csv.lines().count(), 5);
    assert!(
        csv.contains("\"a, b\"")
            && csv.contains("\"\"\"c\"\"\"")
            && csv.contains("0.30000000000000004")
    );
    assert!(!csv.contains("NaN") && csv.contains("\"no, \"\"never\"\"\""));
    let reader = SerializedFileReader::new(Bytes::from(table.to_parquet().unwrap())).unwrap();
    for (row, found) in reader.get_row_iter(None).unwrap().enumerate() {
        let found = found.unwrap();
        let cells: Vec<String> = (found.get_column_iter().zip(&table.columns))
            .map(|((name, field), column)| {
                assert_eq!(name, &column.name);
                match field {
                    Field::Null => String::new(),
                    Field::Str(text) => quoted(text),
                    Field::Double(number) => number.to_string(),
                    Field::Long(number) => number.to_string(),
                    other => panic!("{name}: {other:?}"),
                }
            })
            .collect();
        assert_eq!(Some(cells.join(",").as_str()), csv.lines().nth(1 + row));
    }
}

#[test]
fn what_a_run_cost_does_not_change_the_table() {
    let (plan, rows) = rows();
    let mut other = rows.clone();
    for (_, record) in &mut other {
        record.process_seconds += 1.0;
    }
    let [first, second] = [rows, other].map(|it| Table::new(&plan, &it).to_parquet().unwrap());
    assert_eq!(first, second);
}
