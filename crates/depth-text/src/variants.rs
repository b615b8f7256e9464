//! Enums that know the names of their variants.

/// Declares an enum and the list of its variants' names, against which a test can see that none is forgotten.
macro_rules! variants {
    ($(#[$meta:meta])* pub enum $name:ident {
        $($(#[$doc:meta])* $variant:ident $({ $($fact:ident: $type:ty),* $(,)? })?),* $(,)?
    }) => {
        $(#[$meta])*
        #[allow(missing_docs, reason = "the facts of a sentence have the names of what they are")]
        pub enum $name {
            $($(#[$doc])* $variant $({ $($fact: $type),* })?),*
        }

        impl $name {
            /// The names of all variants.
            pub const NAMES: &[&str] = &[$(stringify!($variant)),*];
        }
    };
}
pub(crate) use variants;
