//! The fonts of a report that stands by itself, as it may be opened where nobody has them.

use crate::app::theme::INTER;

/// The rules of CSS that hold the fonts.
pub fn rules() -> String {
    let rule = |(weight, file): (&str, &[u8])| {
        let file = base64(file);
        format!("@font-face {{ font-family: Inter; font-weight: {weight}; src: url(data:font/ttf;base64,{file}); }}\n")
    };
    INTER.into_iter().map(rule).collect()
}

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits = three.iter().fold(0u32, |bits, byte| bits << 8 | u32::from(*byte)) << (8 * (3 - three.len()));
        for place in 0..4 {
            let sign = usize::try_from(bits >> (18 - 6 * place) & 63)
                .ok()
                .and_then(|index| SIGNS.get(index));
            let is_filling = place > three.len();
            text.push(sign.filter(|_| !is_filling).map_or('=', |sign| char::from(*sign)));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::base64;

    #[test]
    fn the_examples_of_the_standard_come_out() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }
}
