//! Prices of a design, in the units of the document. None of them has a default: a price is what a
//! shop said.

/// Money that prices are in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Currency {
    /// Japanese yen, in whole numbers.
    #[default]
    Yen,
    /// US dollars, with cents.
    Dollar,
}

impl Currency {
    /// Name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Yen => "yen",
            Self::Dollar => "dollar",
        }
    }

    /// A sum as people write it: `¥12,300`, `$24.50`.
    #[must_use]
    pub fn write(self, sum: f64) -> String {
        let (sign, cents) = match self {
            Self::Yen => ("¥", format!("{sum:.0}")),
            Self::Dollar => ("$", format!("{sum:.2}")),
        };
        let whole = cents.find('.').unwrap_or(cents.len());
        let mut text = String::from(sign);
        for (index, letter) in cents.char_indices() {
            let is_group = 0 < index && index < whole && (whole - index).is_multiple_of(3);
            if is_group && cents.as_bytes()[index - 1].is_ascii_digit() {
                text.push(',');
            }
            text.push(letter);
        }
        text
    }
}

/// What a costume's materials and making cost. The price of a cloth stands in its
/// [`FabricDesign`](super::FabricDesign).
#[derive(Debug, Clone, PartialEq)]
pub struct CostDesign {
    /// Of all prices.
    pub currency: Currency,
    /// One meter of elastic.
    pub elastic_price_per_m: Option<f64>,
    /// One meter of tape or cord.
    pub tape_price_per_m: Option<f64>,
    /// One spool of thread.
    pub thread_price_per_spool: Option<f64>,
    /// Thread on one spool [m].
    pub thread_spool_m: f64,
    /// What is bought beside cloth, elastic, tape and thread.
    pub notions: NotionPrices,
    /// All else for one costume.
    pub other_price: Option<f64>,
    /// An hour of sewing; work is not counted when `None`.
    pub wage_per_h: Option<f64>,
    /// The same costume bought ready.
    pub bought_price: Option<f64>,
}

/// Prices of what is bought beside cloth, elastic, tape and thread.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NotionPrices {
    /// One zip.
    pub zip: Option<f64>,
    /// One button.
    pub button: Option<f64>,
    /// One hook and eye.
    pub hook: Option<f64>,
    /// One flower.
    pub flower: Option<f64>,
    /// One pistil.
    pub pistil: Option<f64>,
    /// One leaf or fern.
    pub leaf: Option<f64>,
    /// 100 g of raffia.
    pub raffia_per_100g: Option<f64>,
    /// One meter of cellophane or OPP film.
    pub film_per_m: Option<f64>,
    /// One hair pin or clip.
    pub hair_pin: Option<f64>,
    /// One gourd.
    pub gourd: Option<f64>,
    /// One stick of bamboo.
    pub bamboo: Option<f64>,
    /// One feather.
    pub feather: Option<f64>,
    /// One handle of a rattle.
    pub handle: Option<f64>,
    /// One seed.
    pub seed: Option<f64>,
    /// One sheet of card.
    pub card: Option<f64>,
    /// One tube of glue.
    pub glue: Option<f64>,
}

impl Default for CostDesign {
    fn default() -> Self {
        Self {
            currency: Currency::Yen,
            elastic_price_per_m: None,
            tape_price_per_m: None,
            thread_price_per_spool: None,
            // The usual spool of a Japanese shop.
            thread_spool_m: 200.0,
            notions: NotionPrices::default(),
            other_price: None,
            wage_per_h: None,
            bought_price: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_grouped_by_thousands() {
        for (sum, yen, dollars) in [
            (0.0, "¥0", "$0.00"),
            (980.0, "¥980", "$980.00"),
            (12_300.4, "¥12,300", "$12,300.40"),
            (1_234_567.0, "¥1,234,567", "$1,234,567.00"),
        ] {
            assert_eq!(Currency::Yen.write(sum), yen);
            assert_eq!(Currency::Dollar.write(sum), dollars);
        }
        assert_eq!(Currency::Yen.write(-1500.0), "¥-1,500");
    }
}
