//! Today's date, without a database of time zones.

use std::time::{SystemTime, UNIX_EPOCH};

const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];
const SECONDS_OF_DAY: u64 = 86_400;

/// "November 25, 2026 (UTC)": the date in Greenwich, as which time zone the person is in is for a library to find out.
pub fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    format!("{} (UTC)", written(seconds / SECONDS_OF_DAY))
}

/// The date so many days after January 1, 1970. From Howard Hinnant, "chrono-compatible low-level date algorithms", `civil_from_days`:
/// years start in March, so that the day that comes every four years is the last.
fn written(days: u64) -> String {
    let since_year_0 = days + 719_468;
    let (era, day_of_era) = (since_year_0 / 146_097, since_year_0 % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let since_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * since_march + 2) / 5 + 1;
    let is_next_year = since_march >= 10;
    let year = era * 400 + year_of_era + u64::from(is_next_year);
    let month = usize::try_from((since_march + 2) % 12).ok().and_then(|month| MONTHS.get(month));
    format!("{} {day}, {year}", month.copied().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn days_are_counted_from_1970() {
        for (days, date) in [
            (0, "January 1, 1970"),
            (58, "February 28, 1970"),
            (59, "March 1, 1970"),
            (11_016, "February 29, 2000"),
            (20_782, "November 25, 2026"),
            (20_818, "December 31, 2026"),
            (20_819, "January 1, 2027"),
            (47_540, "February 28, 2100"),
            (47_541, "March 1, 2100"),
        ] {
            assert_eq!(written(days), date, "{days}");
        }
    }
}
